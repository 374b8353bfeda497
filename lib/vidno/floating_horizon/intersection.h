/// Intersection: where a segment meets a horizon. It goes from column to column until the segment is on the other side.
///
/// Source  D. F. Rogers, Procedural Elements for Computer Graphics, 1985, the routine of that name. There the
///         intersection is the nearest column, here it is where the lines cross.
/// Takes   a segment, the columns between which it meets the horizon, the horizon, and whether it is the upper or the
///         lower one.
/// Gives   the first place where the segment comes to be beyond the horizon, or ceases to: on a column if it is on the
///         horizon there, or if the horizon begins or ends there; the last column if there is no such place.
#pragma once

#include "floating_horizon_run.h"

namespace vidno {

struct Intersection {
    template <class Run>
    static typename Run::End intersection(Run& run, const Segment& segment, int first, int last, const auto& horizon,
                                          VisibilityFlag side) {
        using enum Line;
        const auto reached = [&](int x) {
            return reaches_horizon(run.kernel, run.kernel.height(segment, x), horizon[x], side);
        };
        const bool reached_first = reached(first);  // IN1
        for (int x = first; x < last; ++x) {
            const bool changes = reached(x + 1) != reached_first;
            run.trace.step(IN2, x + 1, changes);
            if (changes) return crossing(run, segment, x, horizon);
        }
        return run.on_column(segment, last);  // IN3
    }

private:
    /// The intersection between a column and the next; none if only one of them has a horizon.
    template <class Run>
    static typename Run::End crossing(Run& run, const Segment& segment, int column, const auto& horizon) {
        const auto& left = horizon[column];
        const auto& right = horizon[column + 1];
        if (!left || touches(run, segment, column + 1, right)) return run.on_column(segment, column + 1);
        if (!right || touches(run, segment, column, left)) return run.on_column(segment, column);
        return {run.kernel.crossing(segment, column, *left, *right), column, column + 1};
    }

    static bool touches(auto& run, const Segment& segment, int column, const auto& horizon) {
        return horizon && run.kernel.compare(run.kernel.height(segment, column), *horizon) == Sign::zero;
    }
};

}  // namespace vidno
