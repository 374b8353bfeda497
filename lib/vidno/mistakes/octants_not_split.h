/// OctantsNotSplit: an edge that is seen under half of a full angle is not split.
///
/// Believed   that the numbers of its ends' octants tell the angle of every edge.
/// Goes wrong between octants k and k + 4 the way is as long on either side of the window: the difference is the same, whichever
///            the edge takes.
/// Seen       where a polygon lies around a corner of a window, outside of it: it is taken to surround the window, and may show
///            there; or the other way round.
#pragma once

#include "../family/family.h"

namespace vidno::mistakes {

struct OctantsNotSplit : family::Angles {
    static constexpr std::string_view name = "octants-not-split";

    /// OA4
    static bool needs_split(int /*difference*/) { return false; }
};

}  // namespace vidno::mistakes
