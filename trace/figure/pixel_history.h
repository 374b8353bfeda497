/// PixelHistory: what concerned a pixel, as the events tell it.
#pragma once

#include "drawing.h"
#include "parts.h"

namespace vidno::figures {

class PixelHistory {
public:
    explicit PixelHistory(Pixel pixel) : pixel_(pixel) {}

    Pixel pixel() const { return pixel_; }

    /// Keeps what the step says of the pixel, if it does.
    void take(const Moment& moment);

    /// A table, of a long history the end.
    Drawing part(const Style& style, double width) const;

    struct Entry {
        std::uint64_t step;
        Line at;
        std::string note;
        std::optional<bool> answer;  // none: it is a fact
        bool painted = false;
    };
    const std::vector<Entry>& entries() const { return entries_; }

private:
    Pixel pixel_;
    bool inside_ = false;  // the window at hand, or the row
    std::vector<Entry> entries_;
};

}  // namespace vidno::figures
