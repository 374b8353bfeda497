/// IntegerDivision: a window's sides are halved in whole numbers.
///
/// Believed   that w / 2 twice is w, and that an area of any size may be halved.
/// Goes wrong 3 / 2 is 1: of an odd side the last pixel is in no part. A side of 1 is not halved, here as in the text, so
///            that a window of 1 x 3 has two parts of 1 x 1; a program that halves it too comes to windows of width 0, and
///            if it stops only at a side of exactly 1, never ends.
/// Seen       in areas that are no power-of-two square: columns and rows keep the background.
#pragma once

#include <cmath>

#include "../corrected.h"

namespace vidno::mistakes {

struct IntegerDivision : Corrected {
    static constexpr std::string_view name = "integer-division";

    /// W3: the area itself, of whatever size.
    static Window root_window(const Area& area) { return whole_area(area); }

    /// W13: of an odd side, the parts of the even one before it.
    static std::vector<Window> parts(const Window& window) {
        const auto covered = [](double side) { return side > 1 ? side - std::fmod(side, 2) : side; };
        return parts_of({window.x, window.y, covered(window.width), covered(window.height)});
    }
};

}  // namespace vidno::mistakes
