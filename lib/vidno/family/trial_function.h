/// TrialFunction: does an edge of the polygon meet the window?
///
/// The trial function of an edge, f = A x + B y + C, is 0 on its line: a cross product. If it has both signs at the
/// window's corners, the line passes through the window. The edge is finite and may end before it. The text computes
/// where the line meets the window's sides, and tests whether these points are on the edge. We test the ends instead,
/// without a division and so without rounding: an edge whose line passes through the window misses it only if both ends
/// lie beyond one side.
///
/// Takes   a polygon that is not a point, and a window without its sides: an edge that only touches them does not meet
///         it.
/// Gives   whether an edge meets the window; edges after the first that does are not tested.
/// Time    four cross products an edge.
#pragma once

#include "../run.h"

namespace vidno {

struct TrialFunction {
    /// Does an edge end before the window though its line passes through: are both ends beyond one side?
    static bool ends_before(const auto& from, const auto& to, const auto& upper_left, const auto& lower_right) {
        return (from.x <= upper_left.x && to.x <= upper_left.x) || (from.x >= lower_right.x && to.x >= lower_right.x) ||
               (from.y <= upper_left.y && to.y <= upper_left.y) || (from.y >= lower_right.y && to.y >= lower_right.y);
    }

    template <class Run>
    static bool trial_function(Run& run, const Polygon<typename Run::Arithmetic>& polygon, const Window& window) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;
        const int count = int(vertices.size());
        const auto corners = corners_of(run.kernel, window);

        for (int i = 0; i < count; ++i) {
            const auto& from = vertices[i];
            const auto& to = vertices[(i + 1) % count];
            bool negative = false, positive = false;
            for (const auto& corner : corners) {
                const auto value = run.kernel.cross(from, to, corner);
                const Sign sign = run.kernel.sign(value);
                trace.orient(TF2, polygon, i, corner, value, sign);
                negative = negative || sign == Sign::negative;
                positive = positive || sign == Sign::positive;
            }
            const bool meets = negative && positive && !run.set.ends_before(from, to, corners.front(), corners.back());
            trace.trial(TF3, polygon, i, meets);
            if (meets) return true;
        }
        return false;
    }
};

}  // namespace vidno
