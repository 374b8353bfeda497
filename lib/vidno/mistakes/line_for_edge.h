/// LineForEdge: an edge is taken for the whole line on which it lies.
///
/// Believed   that an edge meets a window if the trial function has both signs at its corners.
/// Goes wrong the line passes through the window, and the edge ends before it.
/// Seen       not in the picture: a polygon outside is taken to intersect the window, which is split needlessly.
#pragma once

#include "../family/family.h"

namespace vidno::mistakes {

struct LineForEdge : family::Full {
    static constexpr std::string_view name = "line-for-edge";

    /// TF3
    static bool ends_before(const auto& /*from*/, const auto& /*to*/, const auto& /*upper_left*/,
                            const auto& /*lower_right*/) {
        return false;
    }
};

}  // namespace vidno::mistakes
