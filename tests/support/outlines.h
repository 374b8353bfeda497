/// Lines, edges and boxes in rationals. Nothing here shares code with the procedures.
#pragma once

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

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

    /// Whether the closed edge holds a place.
    bool holds(const Place& place) const {
        const auto& [low, high] = std::minmax(from, to);
        return cross(from, to, place) == 0 && low <= place && place <= high;
    }
};

using PointOnLine = std::pair<Place, LineThrough>;

/// The line on which two planes have equal depths; none if they are parallel.
inline std::optional<LineThrough> line_of_planes(const ScenePolygon& p, const ScenePolygon& q) {
    const auto over_other = [&](int x, int y) -> Rational { return depth_at(p, {x, y}) - depth_at(q, {x, y}); };
    const Rational at_origin = over_other(0, 0), a = over_other(1, 0) - at_origin, b = over_other(0, 1) - at_origin;
    if (a == 0 && b == 0) return std::nullopt;
    return line(a, b, -at_origin);
}

struct BoxOf {
    Rational xmin, ymin, xmax, ymax;
};

inline BoxOf box_of(const Places& places) {
    const auto [left, top] = places.at(0);
    BoxOf box{left, top, left, top};
    for (const auto& [x, y] : places) {
        box = {std::min<Rational>(box.xmin, x), std::min<Rational>(box.ymin, y), std::max<Rational>(box.xmax, x),
               std::max<Rational>(box.ymax, y)};
    }
    return box;
}

/// Whether the centres of a row of the area have this y.
inline bool is_centre_of_row(const Area& area, const Rational& y) {
    for (int row = area.y; row < area.bottom(); ++row) {
        if (y == Rational(row) + half) return true;
    }
    return false;
}

}  // namespace vidno::test
