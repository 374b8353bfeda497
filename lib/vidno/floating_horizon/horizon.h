/// Horizon: raises the upper horizon to a segment, and lowers the lower one.
///
/// Takes   a segment and the columns first <= x <= last; none if last < first.
/// Gives   over each column the higher of the upper horizon and the segment, and the lower of the lower one and the
///         segment.
#pragma once

#include "floating_horizon_run.h"

namespace vidno {

struct Horizon {
    template <class Run>
    static void horizon(Run& run, const Segment& segment, int first, int last) {
        using enum Line;
        for (int x = first; x <= last; ++x) {  // H1
            const auto y = run.kernel.height(segment, x);
            auto& upper = run.horizons.upper[x];
            auto& lower = run.horizons.lower[x];
            if (!upper || run.kernel.compare(y, *upper) == Sign::positive) {
                upper = y;
                run.trace.raise(H2, x, y);
            }
            if (!lower || run.kernel.compare(y, *lower) == Sign::negative) {
                lower = y;
                run.trace.lower(H3, x, y);
            }
        }
    }
};

}  // namespace vidno
