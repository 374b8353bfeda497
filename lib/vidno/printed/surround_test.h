/// SurroundTest as printed: the search for the first sign does not stop at the end of the list.
///
/// X-W4  for a point that, as computed, lies on the lines of all edges, the search reads past the last vertex: a fault.
#pragma once

#include "../fault.h"
#include "../run.h"

namespace vidno::printed {

struct SurroundTest {
    template <class Run>
    static bool surround_test(Run& run, const typename Run::Place& point,
                              const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;
        const int count = int(vertices.size());

        Sign first_sign = Sign::zero;
        int from = count - 1;
        int to = 0;
        while (first_sign == Sign::zero) {
            if (to == count) throw Fault{S2, "the list of vertices is read past its end"};
            const auto value = run.kernel.cross(vertices[from], vertices[to], point);
            first_sign = run.kernel.sign(value);
            trace.orient(S2, polygon, from, point, value, first_sign);
            from = to++;
        }
        for (; to < count; from = to++) {
            const auto value = run.kernel.cross(vertices[from], vertices[to], point);
            const Sign sign = run.kernel.sign(value);
            trace.orient(S3, polygon, from, point, value, sign);
            if (sign != Sign::zero && sign != first_sign) return false;
        }
        return true;
    }
};

}  // namespace vidno::printed
