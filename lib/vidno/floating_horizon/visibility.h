/// Visibility: where does a point of a curve lie in relation to the horizons?
///
/// Takes   a segment, one of its columns, and the horizons.
/// Gives   above: on the upper horizon or above it; below: on the lower one or below it; both, also where there is no
///         horizon yet; else hidden.
#pragma once

#include "floating_horizon_run.h"

namespace vidno {

struct Visibility {
    template <class Run>
    static VisibilityFlag visibility(Run& run, const Segment& segment, int column, const auto& horizons) {
        using enum Line;
        using enum VisibilityFlag;
        const auto y = run.kernel.height(segment, column);
        const auto& upper = horizons.upper[column];
        const auto& lower = horizons.lower[column];
        run.trace.height(V1, column, y, upper, lower);
        const bool reaches_upper = reaches_horizon(run.kernel, y, upper, above);
        const bool reaches_lower = reaches_horizon(run.kernel, y, lower, below);
        if (reaches_upper && reaches_lower) return run.set.flag_on_both();  // V2
        if (reaches_upper) return above;                                    // V3
        return reaches_lower ? below : hidden;                              // V4
    }
};

}  // namespace vidno
