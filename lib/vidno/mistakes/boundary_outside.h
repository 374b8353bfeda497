/// BoundaryOutside: points on the outline count as outside.
///
/// Believed   that a point with a cross product of 0 is neither on the left nor on the right, so not inside; that a
///            line shows what lies strictly between its ends.
/// Goes wrong a point on the edge that two polygons share belongs to neither.
/// Seen       where a shared edge passes through the centre of a pixel: the background shows. In Warnock's algorithm
///            FillPolygon draws the outline of a polygon alone in its window, and is right.
#pragma once

#include "../corrected.h"

namespace vidno::mistakes {

struct BoundaryOutside : Corrected {
    static constexpr std::string_view name = "boundary-outside";

    /// S3: the sign 0 differs from the others.
    static bool surround_test(auto& run, const auto& point, const auto& polygon) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;
        const int count = int(vertices.size());

        Sign first_sign = Sign::zero;
        int from = count - 1;
        for (int to = 0; to < count; from = to++) {
            const auto value = run.kernel.cross(vertices[from], vertices[to], point);
            const Sign sign = run.kernel.sign(value);
            trace.orient(to == 0 ? S2 : S3, polygon, from, point, value, sign);
            if (to == 0) first_sign = sign;
            if (sign == Sign::zero || sign != first_sign) return false;
        }
        return true;
    }

    /// L4: without the ends. The row of the polygon's highest or lowest point belongs to the outline.
    static std::pair<int, int> columns_shown(const auto& run, int row, const auto& left, const auto& right,
                                             const auto& polygon) {
        const auto& kernel = run.kernel;
        auto [first, end] = Corrected::columns_shown(run, row, left, right, polygon);
        const auto y = kernel.centre(row);
        if (y == polygon.box.ymin || y == polygon.box.ymax) return {first, first};
        if (first < end && kernel.centre(first) == left.x) ++first;
        if (first < end && kernel.centre(end - 1) == right.x) --end;
        return {first, end};
    }
};

}  // namespace vidno::mistakes
