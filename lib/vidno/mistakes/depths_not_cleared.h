/// DepthsNotCleared: Z is not cleared.
///
/// Believed   that a new array is ready for use. In C++ its numbers are 0 or undefined. Another program would find the
///            depths of the previous frame there; this one has no previous frame.
/// Goes wrong a depth must be greater than 0 to be stored in a cell where nothing has been stored yet.
/// Seen       where a polygon lies at z = 0 or behind, with nothing in front of it: the background shows.
#pragma once

#include "../corrected.h"

namespace vidno::mistakes {

struct DepthsNotCleared : Corrected {
    static constexpr std::string_view name = "depths-not-cleared";

    /// Z1
    static auto first_depth(const auto& kernel) { return kernel.depth_of(0); }
};

}  // namespace vidno::mistakes
