/// ClipOrderReversed: the clip traverses the corners of the window in the opposite direction.
///
/// Believed   that any order will do, or that y grows upward, which reverses the direction.
/// Goes wrong a positive cross product now means inside, so each side of the window keeps the part of the polygon
///            beyond it. No point lies beyond all four sides.
/// Seen       where a single polygon crosses a window's side: the window shows the background.
#pragma once

#include <algorithm>

#include "../corrected.h"

namespace vidno::mistakes {

struct ClipOrderReversed : Corrected {
    static constexpr std::string_view name = "clip-order-reversed";

    /// PL2
    static auto corners_around(const auto& kernel, const Window& window) {
        auto corners = Corrected::corners_around(kernel, window);
        std::reverse(corners.begin(), corners.end());
        return corners;
    }
};

}  // namespace vidno::mistakes
