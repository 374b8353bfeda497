/// PixelHistory: the events that concerned a pixel.
#pragma once

#include "drawing.h"
#include "parts.h"

namespace vidno::figures {

class PixelHistory {
public:
    PixelHistory(Pixel pixel, Language language) : pixel_(pixel), language_(language) {}

    Pixel pixel() const { return pixel_; }

    /// Keeps the step if it concerns the pixel.
    void take(const Moment& moment);

    /// The history as a table; only the end of a long one.
    Drawing part(const Style& style, double width) const;

    struct Entry {
        std::uint64_t step;
        Line at;
        std::string note;
        std::optional<bool> answer;  // none: a fact, not a test
        bool painted = false;
    };
    const std::vector<Entry>& entries() const { return entries_; }

private:
    Pixel pixel_;
    Language language_;
    bool inside_ = false;  // the current window, or the row
    std::vector<Entry> entries_;
};

}  // namespace vidno::figures
