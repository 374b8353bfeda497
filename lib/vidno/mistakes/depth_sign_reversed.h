/// DepthSignReversed: the smaller z is nearer.
///
/// Believed   that z := (a x + b y + d) / c, with the minus lost when a x + b y + c z + d = 0 was solved for z; or that
///            z is the distance from the viewer.
/// Goes wrong every depth has the opposite sign, and the farthest polygon is taken for the nearest.
/// Seen       where polygons overlap.
#pragma once

#include "../corrected.h"

namespace vidno::mistakes {

struct DepthSignReversed : Corrected {
    static constexpr std::string_view name = "depth-sign-reversed";

    /// D1
    static auto depth(auto& run, const auto& polygon, const auto& point) {
        const auto& kernel = run.kernel;
        return kernel.depth_of(-kernel.finite(Corrected::depth(run, polygon, point)));
    }
};

}  // namespace vidno::mistakes
