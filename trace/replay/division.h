/// Division: the smallest window of the run so far at each pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "replay/tiles.h"
#include "vidno/window.h"

namespace vidno {

class Division {
public:
    /// `cuts_anywhere`: windows are cut along any boundaries of pixels; otherwise they are halved.
    Division(const Area& area, bool cuts_anywhere) : cuts_anywhere_(cuts_anywhere), marks_(area, 0) {}

    /// Makes a part of the first window, `root`, the smallest window of its pixels. One that is cut anywhere must lie
    /// in the area.
    void divide(const Window& window, const Window& root);

    /// The windows into which `root` is divided, as far as they are `least` wide and high, in the part of the area that
    /// is shown. In place of smaller windows there are the smallest distinguishable ones that contain them, if windows
    /// are halved.
    std::vector<Window> windows(const Window& root, const Area& shown, double least) const;

    std::size_t bytes_of_copy() const { return marks_.bytes_of_copy(); }

private:
    void halve(const Window& window, const Window& root);
    void cut(const Window& window);
    std::vector<Window> halved(const Window& root, const Area& shown, double least) const;
    std::vector<Window> cut_out(double least) const;

    bool cuts_anywhere_;
    /// The number of halvings from the first window; or, where windows are cut anywhere, the sides of the smallest
    /// window at the pixel.
    Tiles<std::uint8_t> marks_;
};

}  // namespace vidno
