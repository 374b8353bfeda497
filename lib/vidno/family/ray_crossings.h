/// RayCrossings: how often does a ray from a point cross a polygon's outline? An odd number of times if the polygon
/// holds it.
///
/// The ray goes to the right. Where it passes through vertices or along edges, the count depends on the side to which
/// the outline leaves the ray. If it returns to the side that it came from, it touches the ray, which counts two. If it
/// leaves to the other side, it pierces the ray, which counts one.
///
/// Takes   a polygon, edge-on or not, and a window that none of its edges meets; the point is the window's centre, so
///         it is not on the outline.
/// Gives   the number of crossings.
/// Time    a cross product for each edge that passes from one side of the ray to the other.
#pragma once

#include "../run.h"

namespace vidno {

struct RayCrossings {
    /// How often a vertex on the ray, or a row of them, counts where the outline touches the ray or pierces it.
    static int crossings_at_vertex(bool touches) { return touches ? 2 : 1; }

    template <class Run>
    static int ray_crossings(Run& run, const Polygon<typename Run::Arithmetic>& polygon, const Window& window) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;
        const int count = int(vertices.size());
        const auto point = run.kernel.point(window.x + window.width / 2, window.y + window.height / 2);
        const auto side_of = [&](const auto& vertex) {
            return Sign{int(vertex.y > point.y) - int(vertex.y < point.y)};
        };

        Sign side = Sign::zero;  // of the last vertex off the ray's line
        for (const auto& vertex : vertices) {
            if (side_of(vertex) != Sign::zero) side = side_of(vertex);
        }
        int crossings = 0;
        int i = count - 1;
        for (int next = 0; next < count; i = next++) {
            const auto& from = vertices[i];
            const auto& to = vertices[next];
            const Sign to_side = side_of(to);
            if (to_side == Sign::zero) continue;
            if (side_of(from) == Sign::zero) {
                const int counts = from.x > point.x ? run.set.crossings_at_vertex(to_side == side) : 0;
                crossings += counts;
                trace.ray(CR3, polygon, i, counts);
            } else if (to_side != side) {
                const auto value = run.kernel.cross(from, to, point);
                const Sign sign = run.kernel.sign(value);
                trace.orient(CR4, polygon, i, point, value, sign);
                const int counts = sign == to_side ? 1 : 0;
                crossings += counts;
                trace.ray(CR4, polygon, i, counts);
            }
            side = to_side;
        }
        return crossings;
    }
};

}  // namespace vidno
