/// DepthsNotCleared: Z is not cleared.
///
/// Believed   that a new array is ready for use. In C++ its numbers are 0, if they are anything; the depths of a frame
///            before, which another program would find there, this one does not have.
/// Goes wrong a depth must be greater than 0 to be stored in a cell that nothing has been stored in yet.
/// Seen       where a polygon lies at z = 0 or behind, with nothing before it: the background shows.
#pragma once

#include "../corrected.h"

namespace vidno::mistakes {

struct DepthsNotCleared : Corrected {
    static constexpr std::string_view name = "depths-not-cleared";

    /// Z1
    static auto first_depth(const auto& kernel) { return kernel.depth_of(0); }
};

}  // namespace vidno::mistakes
