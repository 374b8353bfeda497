/// PixelHistory: the events that concerned a pixel, and why it has its colour, in the words of the page.
#pragma once

#include "drawing.h"
#include "parts.h"
#include "say/pixel_history.h"

namespace vidno::figures {

class PixelHistory {
public:
    /// The header must outlive it.
    PixelHistory(Pixel pixel, const TraceHeader& header, Language language)
        : pixel_(pixel), story_(pixel, header, language) {}

    Pixel pixel() const { return pixel_; }

    /// Keeps the step if it concerns the pixel.
    void take(const Moment& moment);

    /// The history as a table; only the end of a long one.
    Drawing part(const Style& style, double width) const;

    struct Entry {
        std::uint64_t step;
        Line at;
        std::string text;
        say::Outcome outcome;
    };
    const std::vector<Entry>& entries() const { return entries_; }

private:
    Pixel pixel_;
    say::PixelStory story_;
    std::vector<Entry> entries_;
};

}  // namespace vidno::figures
