/// Outlines of regions and what two of them have in common, in rationals. Nothing here shares code with the procedures.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "support/in_rationals.h"

namespace vidno::test {

/// a x + b y = c, the first of a and b that is not 0 is 1.
using LineThrough = std::tuple<Rational, Rational, Rational>;

inline LineThrough line(Rational a, Rational b, Rational c) {
    const Rational scale = a != 0 ? a : b;
    return {a / scale, b / scale, c / scale};
}
inline LineThrough line_through(const Place& p, const Place& q) {
    const Rational a = p.second - q.second, b = q.first - p.first;
    return line(a, b, a * p.first + b * p.second);
}
inline Rational over(const LineThrough& line, const Place& p) {
    const auto& [a, b, c] = line;
    return a * p.first + b * p.second - c;
}

struct EdgeOf {
    Place from, to;

    LineThrough line() const { return line_through(from, to); }
    bool has(const Place& p) const { return p == from || p == to; }
    bool is_same_as(const EdgeOf& other) const { return has(other.from) && has(other.to); }

    /// Whether the closed edge holds a place.
    bool holds(const Place& place) const {
        const auto& [low, high] = std::minmax(from, to);
        return cross(from, to, place) == 0 && low <= place && place <= high;
    }
};

/// A region by its outlines, holes included.
using Outlines = std::vector<Places>;

inline std::vector<EdgeOf> edges_of(const Outlines& region) {
    std::vector<EdgeOf> edges;
    for (const auto& outline : region) {
        for_each_edge_of(outline, [&](const Place& from, const Place& to) { edges.push_back({from, to}); });
    }
    return edges;
}

using PointOnLine = std::pair<Place, LineThrough>;

/// The coincidences of two overlaid regions: vertices of one on lines of the other, and common vertices.
struct Coincidences {
    std::set<PointOnLine> on_lines;
    std::set<Place> common;
    bool operator==(const Coincidences&) const = default;
};

/// A common edge counts as one edge, and vertices that are on it by construction are not tested. The line of an edge of the subject is
/// tested where it may meet an edge of the clip region, that is, where the line of that edge meets the subject's edge.
inline Coincidences coincidences(const Outlines& subject, const Outlines& clip) {
    Coincidences found;
    const auto is_shared = [](const EdgeOf& edge, const std::vector<EdgeOf>& others) {
        return std::any_of(others.begin(), others.end(), [&](const EdgeOf& other) { return edge.is_same_as(other); });
    };
    const auto subject_edges = edges_of(subject), clip_edges = edges_of(clip);
    const auto on_own_edge = [](const Place& vertex, const EdgeOf& edge, const std::vector<EdgeOf>& own) {
        return std::any_of(own.begin(), own.end(),
                           [&](const EdgeOf& each) { return each.has(vertex) && each.is_same_as(edge); });
    };
    for (const auto& e : subject_edges) {
        for (const auto& f : clip_edges) {
            const Rational from = over(f.line(), e.from), to = over(f.line(), e.to);
            for (const auto& end : {e.from, e.to}) {
                if (over(f.line(), end) == 0 && !on_own_edge(end, f, subject_edges)) {
                    found.on_lines.emplace(end, f.line());
                }
            }
            if ((from < 0 && to < 0) || (from > 0 && to > 0)) continue;
            for (const auto& end : {f.from, f.to}) {
                if (over(e.line(), end) == 0 && !on_own_edge(end, e, clip_edges)) {
                    found.on_lines.emplace(end, e.line());
                }
            }
        }
    }
    for (const auto& ending : clip_edges) {
        const Place& vertex = ending.to;
        const auto has_vertex = [&](const EdgeOf& edge) { return edge.has(vertex); };
        if (std::none_of(subject_edges.begin(), subject_edges.end(), has_vertex)) continue;
        int shared = 0;
        for (const auto& edge : clip_edges) shared += edge.has(vertex) && is_shared(edge, subject_edges) ? 1 : 0;
        if (shared < 2) found.common.insert(vertex);
    }
    return found;
}

/// Whether two convex polygons share area: no line of an edge separates them.
inline bool overlap(const Places& p, const Places& q) {
    const auto separates = [](const EdgeOf& edge, const Places& own, const Places& other) {
        const auto all = [&](const Places& places, int side) {
            return std::all_of(places.begin(), places.end(),
                               [&](const Place& each) { return side * over(edge.line(), each) >= 0; });
        };
        return (all(own, 1) && all(other, -1)) || (all(own, -1) && all(other, 1));
    };
    for (const auto& edge : edges_of({p})) {
        if (separates(edge, p, q)) return false;
    }
    for (const auto& edge : edges_of({q})) {
        if (separates(edge, q, p)) return false;
    }
    return true;
}

/// The line on which two planes have equal depths; none if they are parallel. Positive where the first is nearer.
inline std::optional<LineThrough> line_of_planes(const ScenePolygon& p, const ScenePolygon& q) {
    const auto over_other = [&](int x, int y) -> Rational { return depth_at(p, {x, y}) - depth_at(q, {x, y}); };
    const Rational at_origin = over_other(0, 0), a = over_other(1, 0) - at_origin, b = over_other(0, 1) - at_origin;
    if (a == 0 && b == 0) return std::nullopt;
    return line(a, b, -at_origin);
}

inline bool is_on_both_sides(const LineThrough& line, const Places& places) {
    const auto is_positive = [&](const Place& each) { return over(line, each) > 0; };
    const auto is_negative = [&](const Place& each) { return over(line, each) < 0; };
    return std::any_of(places.begin(), places.end(), is_positive) &&
           std::any_of(places.begin(), places.end(), is_negative);
}

/// The part of a convex outline inside an edge of another one, which has this turn.
inline Places part_inside(const Places& outline, const Place& from, const Place& to, const Rational& turn) {
    return cut_off(outline, [&](const Place& place) -> Rational { return -cross(from, to, place) * turn; });
}

/// The vertices of the part that two convex outlines have in common.
inline Places common_part(const Places& p, const Places& q) {
    Places inside = p;
    const Rational turn = cross(q[0], q[1], q[2]);
    for_each_edge_of(q, [&](const Place& from, const Place& to) { inside = part_inside(inside, from, to, turn); });
    return inside;
}

struct BoxOf {
    Rational xmin, ymin, xmax, ymax;
};

inline BoxOf box_of(const Outlines& outlines) {
    const Place& first = outlines.at(0).at(0);
    BoxOf box{first.first, first.second, first.first, first.second};
    for (const auto& outline : outlines) {
        for (const auto& [x, y] : outline) {
            box = {std::min<Rational>(box.xmin, x), std::min<Rational>(box.ymin, y), std::max<Rational>(box.xmax, x),
                   std::max<Rational>(box.ymax, y)};
        }
    }
    return box;
}

inline bool boxes_overlap(const Places& p, const Places& q) {
    const BoxOf a = box_of({p}), b = box_of({q});
    return a.xmin < b.xmax && b.xmin < a.xmax && a.ymin < b.ymax && b.ymin < a.ymax;
}

/// Whether the centres of a row of the area have this y.
inline bool is_centre_of_row(const Area& area, const Rational& y) {
    for (int row = area.y; row < area.bottom(); ++row) {
        if (y == Rational(row) + half) return true;
    }
    return false;
}

inline Places outline_in(const Area& area, const ScenePolygon& polygon) {
    return clipped(whole_area(area), outline_of(polygon));
}

/// Adds the pixels of the area whose centres are an end of an outline on their row.
inline void add_centres_at_ends(const Area& area, const Places& outline, std::set<std::pair<int, int>>& pixels) {
    for (int y = area.y; y < area.bottom(); ++y) {
        const auto on_row = ends_on_row(outline, y);
        for (int x = area.x; on_row && x < area.right(); ++x) {
            const Rational centre = Rational(x) + half;
            if (centre == on_row->first || centre == on_row->second) pixels.emplace(x, y);
        }
    }
}

/// Whether a point is found on a convex outline. On a level lower side it is not: there a ray to the right, for which points on its row
/// count as below it, has found it inside.
inline bool is_found_on(const Places& outline, const Place& point) {
    const auto by_y = [](const Place& p, const Place& q) { return p.second < q.second; };
    const Rational top = std::min_element(outline.begin(), outline.end(), by_y)->second;
    bool found = false;
    for_each_edge_of(outline, [&](const Place& from, const Place& to) {
        if (!EdgeOf{from, to}.holds(point)) return;
        found = found || std::min(from.second, to.second) < point.second || point.second == top;
    });
    return found;
}

}  // namespace vidno::test
