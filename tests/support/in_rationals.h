/// Polygons, pixels and depths by the picture rule, in rationals. Nothing here shares code with the procedures.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "vidno/admitted.h"
#include "vidno/kernels/exact.h"
#include "vidno/window.h"

namespace vidno::test {

using Place = std::pair<Rational, Rational>;
using Places = std::vector<Place>;

inline const Rational half = Rational(1) / 2;

inline Place place_of(const glm::dvec3& vertex) { return {vertex.x, vertex.y}; }

inline Places outline_of(const ScenePolygon& polygon) {
    Places outline;
    for (const auto& vertex : polygon.vertices) outline.push_back(place_of(vertex));
    return outline;
}

/// (q - p) x (v - p)
inline Rational cross(const Place& p, const Place& q, const Place& v) {
    return (q.first - p.first) * (v.second - p.second) - (q.second - p.second) * (v.first - p.first);
}

inline Place centre_of_pixel(int x, int y) { return {Rational(x) + half, Rational(y) + half}; }

/// Where a linear function is 0 that has these values, of different signs, at two places.
inline Place zero_between(const Place& p, const Rational& at_p, const Place& q, const Rational& at_q) {
    const Rational part = at_p / (at_p - at_q);
    return {p.first + (q.first - p.first) * part, p.second + (q.second - p.second) * part};
}

/// visit(from, to) for each edge.
void for_each_edge_of(const Places& outline, auto&& visit) {
    for (std::size_t i = 0; i < outline.size(); ++i) visit(outline[i], outline[(i + 1) % outline.size()]);
}

/// The ends of a closed convex outline on a row's centre line; none if it does not reach it.
inline std::optional<std::pair<Rational, Rational>> ends_on_row(const Places& outline, int row) {
    const Rational y = Rational(row) + half;
    std::optional<std::pair<Rational, Rational>> found;
    const auto include = [&](const Rational& x) {
        if (!found) found.emplace(x, x);
        found->first = std::min(found->first, x);
        found->second = std::max(found->second, x);
    };
    for_each_edge_of(outline, [&](const Place& p, const Place& q) {
        if ((y < p.second && y < q.second) || (y > p.second && y > q.second)) return;
        if (p.second == q.second) {
            include(p.first);
            include(q.first);
        } else {
            include(p.first + (y - p.second) * (q.first - p.first) / (q.second - p.second));
        }
    });
    return found;
}

/// As in the picture rule, a polygon without width covers no pixel.
inline bool covers(const ScenePolygon& polygon, int x, int y) {
    if (polygon.edge_on) return false;
    const auto on_row = ends_on_row(outline_of(polygon), y);
    const Rational centre = Rational(x) + half;
    return on_row && on_row->first <= centre && centre <= on_row->second;
}

/// How far a point lies beyond a side of a window, positive outside; sides: top, left, bottom, right.
inline Rational beyond(int side, const Window& window, const Place& p) {
    switch (side) {
        case 0: return Rational(window.y) - p.second;
        case 1: return Rational(window.x) - p.first;
        case 2: return p.second - Rational(window.bottom());
        default: return p.first - Rational(window.right());
    }
}

/// A convex outline without its part where `beyond(place)`, a linear function, is positive. It starts with the edge
/// that ends at the first vertex.
Places cut_off(const Places& outline, auto&& beyond) {
    Places inside;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Place& from = outline[i == 0 ? outline.size() - 1 : i - 1];
        const Place& to = outline[i];
        const Rational f = beyond(from), t = beyond(to);
        if ((f < 0 && t > 0) || (f > 0 && t < 0)) inside.push_back(zero_between(from, f, to, t));
        if (t <= 0) inside.push_back(to);
    }
    return inside;
}

inline Places clipped(int side, const Window& window, const Places& outline) {
    return cut_off(outline, [&](const Place& place) { return beyond(side, window, place); });
}

inline Places clipped(const Window& window, Places outline) {
    for (int side = 0; side < 4; ++side) outline = clipped(side, window, outline);
    return outline;
}

/// The depth of a polygon's plane at a point, by three of its vertices.
inline Rational depth_at(const ScenePolygon& polygon, const Place& point) {
    const auto& v = polygon.vertices;
    const Place origin = place_of(v[0]);
    for (std::size_t i = 1; i + 1 < v.size(); ++i) {
        const Place p = place_of(v[i]), q = place_of(v[i + 1]);
        const Rational area = cross(origin, p, q);
        if (area == 0) continue;
        const Rational s = cross(origin, point, q) / area, t = cross(origin, p, point) / area;
        const Rational z(v[0].z);
        return z + s * (Rational(v[i].z) - z) + t * (Rational(v[i + 1].z) - z);
    }
    FAIL("a polygon without area has no plane");
    return 0;
}

/// Whether all vertices of each polygon lie in one plane exactly, so that any three of them give the same plane.
inline bool all_planar(const AdmittedScene& scene) {
    return std::all_of(scene->polygons.begin(), scene->polygons.end(), [](const auto& polygon) {
        return polygon.edge_on || std::all_of(polygon.vertices.begin(), polygon.vertices.end(), [&](const auto& v) {
                   return depth_at(polygon, place_of(v)) == Rational(v.z);
               });
    });
}

using PolygonsAtPixel = std::tuple<int, int, int, int>;  // two polygons, the nearer one so far last, x, y

/// The depth of a polygon at a pixel's centre; none if it does not cover it.
inline std::optional<Rational> depth_at_pixel(const ScenePolygon& polygon, int x, int y) {
    if (!covers(polygon, x, y)) return std::nullopt;
    return depth_at(polygon, centre_of_pixel(x, y));
}

/// Adds the polygons that are exactly as near as the nearest before them in the scene, by their depths at the pixel.
template <class Depth = decltype(&depth_at_pixel)>
void add_ties(const AdmittedScene& scene, int x, int y, std::set<PolygonsAtPixel>& ties,
              Depth&& depth_of = &depth_at_pixel) {
    int nearest = -1;
    Rational depth;
    for (int p = 0; p < int(scene->polygons.size()); ++p) {
        const std::optional<Rational> z = depth_of(scene->polygons[std::size_t(p)], x, y);
        if (!z) continue;
        if (nearest >= 0 && *z == depth) ties.emplace(p, nearest, x, y);
        if (nearest >= 0 && *z <= depth) continue;
        nearest = p;
        depth = *z;
    }
}

}  // namespace vidno::test
