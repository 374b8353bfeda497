/// EdgeDepth: an edge-on polygon is the segment that it is projected to, as near as its nearest point in the line of
/// sight.
///
/// Its plane is parallel to the lines of sight and gives no depth. A line of sight that meets the polygon meets its
/// outline. The nearest of the edges that it crosses is the one with the greatest depth. Where it runs along an edge,
/// the nearest point is the nearer end.
#pragma once

#include "../run.h"

namespace vidno {

struct EdgeDepth {
    /// Takes   a run before any depth is computed.
    /// Gives   each edge-on polygon the depths of its edges, as planes. Many planes pass through an edge. We choose one
    ///         whose depth changes with x alone, or with y alone, or not at all. Its third corner may lie anywhere
    ///         along the other axis. It is put on a side of the area, where no kernel that is always right rounds it.
    template <class Run>
    static void initialize_edges(Run& run) {
        for (auto& polygon : run.polygons) {
            if (!polygon.edge_on) continue;
            const auto& vertices = polygon.vertices;
            for (std::size_t i = 0; i < vertices.size(); ++i) {
                auto& edge = polygon.edges.emplace_back();
                edge.corners = corners_of_plane(run, vertices[i], vertices[(i + 1) % vertices.size()]);
                edge.plane = run.kernel.plane(run.set.initialize_polygon(run, edge.corners), edge.corners);  // ED1
            }
        }
    }

    /// Takes   a point and an edge-on polygon.
    /// Gives   whether the point lies on the closed segment: on its line, and in its box.
    template <class Run>
    static bool on_segment(Run& run, const typename Run::Place& point,
                           const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;
        const int count = int(vertices.size());
        const auto& [xmin, ymin, xmax, ymax] = polygon.box;
        if (!(xmin <= point.x && point.x <= xmax && ymin <= point.y && point.y <= ymax)) return false;  // ED2
        for (int i = 0; i < count; ++i) {
            const auto value = run.kernel.cross(vertices[i], vertices[(i + 1) % count], point);
            const Sign sign = run.kernel.sign(value);
            trace.orient(ED3, polygon, i, point, value, sign);
            if (sign != Sign::zero) return false;
        }
        return true;
    }

    /// Takes   a point of the closed segment.
    /// Gives   the greatest depth of the edges there.
    template <class Run>
    static typename Run::Depth edge_depth(Run& run, const Polygon<typename Run::Arithmetic>& polygon,
                                          const auto& point) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;
        auto nearest = run.kernel.farthest();
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto& from = vertices[i];
            const auto& to = vertices[(i + 1) % vertices.size()];
            if (!(between(from.x, point.x, to.x) && between(from.y, point.y, to.y))) continue;  // ED4
            const auto z = run.kernel.depth(polygon.edges[i].plane, point);
            trace.edge_depth(ED5, polygon, int(i), z);
            if (run.kernel.nearer(z, nearest, point)) nearest = z;  // ED6
        }
        return nearest;
    }

private:
    static bool between(const auto& a, const auto& value, const auto& b) {
        return (a <= value && value <= b) || (b <= value && value <= a);
    }

    template <class Run>
    static typename Run::Vertices corners_of_plane(Run& run, const auto& from, const auto& to) {
        const auto upper_left = run.kernel.point(run.area.x, run.area.y);
        const auto lower_right = run.kernel.point(run.area.right(), run.area.bottom());
        const auto other_x = [&](const auto& v) { return v.x == upper_left.x ? lower_right.x : upper_left.x; };
        const auto other_y = [&](const auto& v) { return v.y == upper_left.y ? lower_right.y : upper_left.y; };
        if (from.x != to.x) return {from, to, {from.x, other_y(from), from.z}};
        if (from.y != to.y) return {from, to, {other_x(from), from.y, from.z}};
        const auto& nearer = from.z < to.z ? to : from;
        return {nearer, {other_x(nearer), nearer.y, nearer.z}, {nearer.x, other_y(nearer), nearer.z}};
    }
};

}  // namespace vidno
