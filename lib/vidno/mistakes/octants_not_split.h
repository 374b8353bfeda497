/// OctantsNotSplit: an edge that subtends a straight angle is not split.
///
/// Believed   that the numbers of its ends' octants tell the angle of every edge.
/// Goes wrong from octant k to k + 4 both ways around the window are equally long: the difference is the same,
///            whichever way the edge takes.
/// Seen       where a polygon lies around a corner of a window, outside it: it is taken to surround the window, and may
///            show there; or the other way round.
#pragma once

#include "../family/family.h"

namespace vidno::mistakes {

struct OctantsNotSplit : family::Angles {
    static constexpr std::string_view name = "octants-not-split";

    /// OA4
    static bool needs_split(int /*difference*/) { return false; }
};

}  // namespace vidno::mistakes
