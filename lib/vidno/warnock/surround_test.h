/// SurroundTest: does a convex polygon hold a point?
///
/// Takes   a point, and a polygon in either orientation.
/// Gives   true if the point is on the same side of all edges, except those whose line it is on. A point on the outline
///         counts as inside. If the point is on the lines of all edges (a polygon without area), the answer is false.
/// Time    one cross product for each edge, up to the first with another sign.
#pragma once

#include "../run.h"

namespace vidno {

struct SurroundTest {
    template <class Run>
    static bool surround_test(Run& run, const typename Run::Place& point,
                              const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;

        Sign first_sign = Sign::zero;
        const auto* from = &vertices.back();
        for (const auto& to : vertices) {
            const auto value = run.kernel.cross(*from, to, point);
            const Sign sign = run.kernel.sign(value);
            trace.orient(first_sign == Sign::zero ? S2 : S3, polygon, int(from - vertices.data()), point, value, sign);
            from = &to;
            if (sign == Sign::zero) continue;
            if (first_sign == Sign::zero) first_sign = sign;
            if (sign != first_sign) return false;
        }
        return first_sign != Sign::zero;
    }
};

}  // namespace vidno
