/// InitializePolygon as printed: the determinants of the first three vertices.
///
/// X-W6  if these are collinear, a = b = c = d = 0, and the polygon is lost.
#pragma once

#include "../run.h"

namespace vidno::printed {

struct InitializePolygon {
    template <class Run>
    static Plane<typename Run::Number> initialize_polygon(Run&, const typename Run::Vertices& vertices) {
        using Number = typename Run::Number;
        const auto& [x1, y1, z1] = vertices[0];
        const auto& [x2, y2, z2] = vertices[1];
        const auto& [x3, y3, z3] = vertices[2];
        // The terms are in the order of the determinants' expansion by their first column.
        const Number a = (y2 * z3 - z2 * y3) - (y1 * z3 - z1 * y3) + (y1 * z2 - z1 * y2);
        const Number b = (z2 * x3 - x2 * z3) - (z1 * x3 - x1 * z3) + (z1 * x2 - x1 * z2);
        const Number c = (x2 * y3 - y2 * x3) - (x1 * y3 - y1 * x3) + (x1 * y2 - y1 * x2);
        const Number d = -(x1 * (y2 * z3 - z2 * y3) - x2 * (y1 * z3 - z1 * y3) + x3 * (y1 * z2 - z1 * y2));
        return {a, b, c, d};
    }
};

}  // namespace vidno::printed
