/// IntegerDivision: a window's sides are halved in whole numbers.
///
/// Believed   that w / 2 twice is w, and that an area of any size may be halved.
/// Goes wrong 3 / 2 is 1: the last pixel of an odd side is in no part. As in the text, a side of 1 is not halved, so a
///            window of 1 x 3 has two parts of 1 x 1. A program that halves it too arrives at windows of width 0, and
///            never ends if it stops only at a side of exactly 1.
/// Seen       in areas that are not a power-of-two square: columns and rows keep the background.
#pragma once

#include <cmath>

#include "../corrected.h"

namespace vidno::mistakes {

struct IntegerDivision : Corrected {
    static constexpr std::string_view name = "integer-division";

    /// W3: the area itself, of any size.
    static Window root_window(const Area& area) { return whole_area(area); }

    /// W13: an odd side is split like the even one below it.
    static WindowParts parts(const Window& window) {
        const auto covered = [](double side) { return side > 1 ? side - std::fmod(side, 2) : side; };
        return parts_of({window.x, window.y, covered(window.width), covered(window.height)});
    }
};

}  // namespace vidno::mistakes
