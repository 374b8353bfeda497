#include "grade/scene_truth.h"

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <map>

#include "grade/magnitude.h"
#include "grade/winding.h"
#include "grade/words.h"
#include "json/json_text.h"
#include "vidno/kernels/exact.h"

namespace vidno {

namespace {

using grading::area_where;
using grading::cross;
using grading::Layer;
using grading::Outline2;
using grading::Point2;

Outline2 exactly(const std::vector<glm::dvec2>& corners) {
    Outline2 outline;
    for (const auto& each : corners) outline.push_back({each.x, each.y});
    return outline;
}

/// The side of the line from -> to on which p lies: 1, -1, or 0 if p is within about `open` of the line. None if
/// intervals leave it open.
template <class Number>
std::optional<int> side_in(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& p, double open) {
    const Number along_x = Number(to.x) - Number(from.x), along_y = Number(to.y) - Number(from.y);
    const Number value = along_x * (Number(p.y) - Number(from.y)) - along_y * (Number(p.x) - Number(from.x));
    const Number reach = Number(open) * (Number(CGAL::abs(along_x)) + Number(CGAL::abs(along_y)));
    const auto is_beyond = value > reach, is_before = value < Number(-reach);
    if (CGAL::certainly(is_beyond)) return 1;
    if (CGAL::certainly(is_before)) return -1;
    if (CGAL::certainly_not(is_beyond) && CGAL::certainly_not(is_before)) return 0;
    return std::nullopt;
}

/// Twice the area, positive if the outline turns from x to y.
Rational twice_area(const Outline2& outline) {
    Rational sum(0);
    for (std::size_t i = 2; i < outline.size(); ++i) sum += cross(outline[0], outline[i - 1], outline[i]);
    return sum;
}

struct ExactPolygon {
    std::vector<glm::dvec2> corners;  // of the outline
    Outline2 outline;                 // without edges of length 0; its area is positive
    Rational zx, zy, z0;              // z = zx x + zy y + z0
    double depth_slack = 0;           // the tolerance of a depth
    bool has_inside = false;

    Rational depth(const Point2& p) const { return zx * p.x + zy * p.y + z0; }
};

/// Uses Newell's sum about the first vertex, as the procedures do.
void set_plane(ExactPolygon& polygon, const std::vector<glm::dvec3>& vertices, double extent, double largest,
               double unit) {
    const glm::dvec3& o = vertices[0];
    Rational a(0), b(0), c(0);
    const auto from_first = [&](const glm::dvec3& v) {
        return std::array<Rational, 3>{Rational(v.x) - Rational(o.x), Rational(v.y) - Rational(o.y),
                                       Rational(v.z) - Rational(o.z)};
    };
    for (std::size_t i = 2; i < vertices.size(); ++i) {
        const auto u = from_first(vertices[i - 1]), v = from_first(vertices[i]);
        a += u[1] * v[2] - u[2] * v[1];
        b += u[2] * v[0] - u[0] * v[2];
        c += u[0] * v[1] - u[1] * v[0];
    }
    polygon.zx = -a / c;
    polygon.zy = -b / c;
    polygon.z0 = Rational(o.z) - polygon.zx * Rational(o.x) - polygon.zy * Rational(o.y);
    // The thinner a polygon, the less accurately its vertices determine its plane.
    const double thinness = std::max(1.0, extent * extent / std::abs(CGAL::to_double(c)));
    // A depth is at most 1, and is computed from terms as large as this.
    const double terms = 1 + largest * (std::abs(CGAL::to_double(polygon.zx)) + std::abs(CGAL::to_double(polygon.zy)));
    polygon.depth_slack = unit * thinness * terms;
}

/// The part of an outline where `beyond`, a linear function of a point, is not negative.
Outline2 half_of(const Outline2& outline, const auto& beyond) {
    Outline2 kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
        const Rational vp = beyond(p), vq = beyond(q);
        if (vp >= 0) kept.push_back(p);
        if ((vp < 0 && vq > 0) || (vp > 0 && vq < 0)) {
            const Rational t = vp / (vp - vq);
            kept.push_back({p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t});
        }
    }
    return kept;
}

Outline2 part_of(const Outline2& outline, const Window& window) {
    const Rational left(window.x), right(window.right()), top(window.y), bottom(window.bottom());
    Outline2 part = half_of(outline, [&](const Point2& p) { return Rational(p.x - left); });
    part = half_of(part, [&](const Point2& p) { return Rational(right - p.x); });
    part = half_of(part, [&](const Point2& p) { return Rational(p.y - top); });
    return half_of(part, [&](const Point2& p) { return Rational(bottom - p.y); });
}

Layer exactly(const RegionLoops& region) {
    Layer layer;
    for (const auto& loop : region) {
        layer.emplace_back();
        for (const ValuePoint& p : loop) layer.back().push_back({p.x.number, p.y.number});
    }
    return layer;
}

struct Direction {
    double x, y;
};

/// A direction strictly between any two neighbours among the edges' directions, where what is visible can change. Their
/// opposites and perpendiculars count too, so no gap between neighbours is more than 90 degrees.
std::vector<Direction> directions_between(const std::vector<Direction>& changes) {
    std::vector<Direction> all;
    for (const auto& [x, y] : changes) {
        const double length = std::hypot(x, y);
        for (const auto& [u, v] : {Direction{x, y}, {-x, -y}, {y, -x}, {-y, x}})
            all.push_back({u / length, v / length});
    }
    const auto angle = [](const Direction& d) { return std::atan2(d.y, d.x); };
    std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
    std::vector<Direction> between;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& next = all[(i + 1) % all.size()];
        if (all[i].x != next.x || all[i].y != next.y) between.push_back({all[i].x + next.x, all[i].y + next.y});
    }
    return between;
}

}  // namespace

struct SceneTruth::Exactly {
    Scene scene;
    double largest = 1;  // coordinate
    double slack = 0;    // the tolerance of a coordinate
    std::vector<ExactPolygon> polygons;
    Precision precision;
    mutable std::map<std::pair<int, int>, SeenPixel> pixels;  // a cache
    mutable bool shows_single = false;

    Exactly(const Scene& given, Precision of) : scene(given), precision(of) {
        const Area& area = scene.area;
        for (const int v : {area.x, area.y, area.right(), area.bottom()})
            largest = std::max(largest, std::abs(double(v)));
        for (const auto& polygon : scene.polygons) {
            for (const auto& v : polygon.vertices) largest = std::max({largest, std::abs(v.x), std::abs(v.y)});
        }
        slack = largest * rounding(precision);
        for (const auto& polygon : scene.polygons) polygons.push_back(exact_polygon(polygon));
    }

    ExactPolygon exact_polygon(const ScenePolygon& source) const {
        ExactPolygon polygon;
        const auto& vertices = source.vertices;
        double extent = 0;
        for (const auto& v : vertices) {
            extent = std::max({extent, std::abs(v.x - vertices[0].x), std::abs(v.y - vertices[0].y)});
            const auto& next = vertices[std::size_t(&v - vertices.data() + 1) % vertices.size()];
            if (v.x != next.x || v.y != next.y) polygon.corners.emplace_back(v);
        }
        polygon.outline = exactly(polygon.corners);
        const Rational area = twice_area(polygon.outline);
        polygon.has_inside = area != 0;
        if (area < 0) {
            std::reverse(polygon.corners.begin(), polygon.corners.end());
            std::reverse(polygon.outline.begin(), polygon.outline.end());
        }
        if (polygon.has_inside) set_plane(polygon, vertices, extent, largest, rounding(precision));
        return polygon;
    }

    const ExactPolygon& at(int polygon) const { return polygons[std::size_t(polygon)]; }

    double most_depth_slack() const {
        double most = 0;
        for (const auto& polygon : polygons) most = std::max(most, polygon.depth_slack);
        return most;
    }

    /// A tolerance for a number that the program tells.
    double open(double tolerance, double claimed) const { return tolerance * strictness(precision, claimed); }

    /// Depths of a program in double are floats only if the right ones are.
    void look_for_single(const Rational& right, double claimed, double tolerance) const {
        if (precision == Precision::single || !is_float(claimed) ||
            Rational(double(float(CGAL::to_double(right)))) == right)
            return;
        const double single = tolerance * rounding(Precision::single) / rounding(Precision::twice);
        shows_single = shows_single || magnitude(right - Rational(claimed)) <= Rational(single);
    }

    /// The side of the line from -> to on which p lies: 1, -1, or 0 if p is within about `open` of the line.
    static int side_of(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& p, double open) {
        // Rationals take sixty times as many instructions, and few points are that near.
        const auto side = side_in<CGAL::Interval_nt<>>(from, to, p, open);
        return side ? *side : *side_in<Rational>(from, to, p, open);
    }

    /// Whether an edge of the region has the region on one side and the other one on the other side, so that they share
    /// no area.
    bool apart(const RegionLoops& region, const RegionLoops& other) const {
        const auto all_of = [](const RegionLoops& loops, auto&& holds) {
            return std::all_of(loops.begin(), loops.end(),
                               [&](const auto& loop) { return std::all_of(loop.begin(), loop.end(), holds); });
        };
        const auto place = [](const ValuePoint& p) { return glm::dvec2(p.x.number, p.y.number); };
        for (const auto& loop : region) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const glm::dvec2 from = place(loop[i]), to = place(loop[(i + 1) % loop.size()]);
                const auto side = [&](const ValuePoint& p) { return side_of(from, to, place(p), slack); };
                if (from != to && all_of(region, [&](const auto& p) { return side(p) >= 0; }) &&
                    all_of(other, [&](const auto& p) { return side(p) <= 0; }))
                    return true;
            }
        }
        return false;
    }

    Place place(const ExactPolygon& polygon, const glm::dvec2& p, double open) const {
        if (!polygon.has_inside) return Place::outside;
        Place found = Place::inside;
        const auto& corners = polygon.corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const int side = side_of(corners[i], corners[(i + 1) % corners.size()], p, open);
            if (side < 0) return Place::outside;
            if (side == 0) found = Place::outline;
        }
        return found;
    }

    /// The candidates that may be taken for the nearest at the point; the background if there are no candidates.
    std::vector<int> front_of(const std::vector<int>& candidates, const Point2& p) const {
        if (candidates.empty()) return {SeenPixel::background};
        const auto farther = [&](int q, int r) { return at(q).depth(p) < at(r).depth(p); };
        const int nearest = *std::max_element(candidates.begin(), candidates.end(), farther);
        std::vector<int> front;
        for (const int q : candidates) {
            const double open = at(q).depth_slack + at(nearest).depth_slack;
            if (at(q).depth(p) + Rational(open) >= at(nearest).depth(p)) front.push_back(q);
        }
        return front;
    }

    /// p lies on the outline: whether the points next to p in that direction belong to the polygon.
    bool goes_on(const ExactPolygon& polygon, const glm::dvec2& p, const Direction& direction) const {
        for (std::size_t i = 0; i < polygon.outline.size(); ++i) {
            const std::size_t next = (i + 1) % polygon.outline.size();
            if (side_of(polygon.corners[i], polygon.corners[next], p, slack) != 0) continue;
            const Point2 &from = polygon.outline[i], &to = polygon.outline[next];
            const Rational turn = (to.x - from.x) * Rational(direction.y) - (to.y - from.y) * Rational(direction.x);
            if (turn <= 0) return false;
        }
        return true;
    }

    std::vector<Direction> changes_at(const glm::dvec2& p, const std::vector<int>& on) const {
        std::vector<Direction> changes;
        for (const int q : on) {
            const Outline2& outline = at(q).outline;
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const std::size_t next = (i + 1) % outline.size();
                if (side_of(at(q).corners[i], at(q).corners[next], p, slack) != 0) continue;
                const Point2 &from = outline[i], &to = outline[next];
                changes.push_back({CGAL::to_double(Rational(to.x - from.x)), CGAL::to_double(Rational(to.y - from.y))});
            }
        }
        return changes;
    }

    SeenPixel see(int column, int row) const {
        const glm::dvec2 centre(column + 0.5, row + 0.5);
        const Point2 p{centre.x, centre.y};
        std::vector<int> in, on, closed;
        SeenPixel seen;
        for (int q = 0; q < int(polygons.size()); ++q) {
            const Place where = place(at(q), centre, slack);
            if (where == Place::inside) in.push_back(q);
            if (where == Place::outline) on.push_back(q);
            if (place(at(q), centre, 0) == Place::outside) continue;
            closed.push_back(q);
            if (seen.by_rule == SeenPixel::background || at(q).depth(p) > at(seen.by_rule).depth(p)) seen.by_rule = q;
        }
        seen.on_outline = !on.empty();
        if (seen.by_rule != SeenPixel::background) {
            const auto differs = [&](int q) { return at(q).depth(p) != at(seen.by_rule).depth(p); };
            const std::vector<int> front = front_of(closed, p);
            seen.is_open = std::any_of(front.begin(), front.end(), differs);
        }
        seen.by_none = front_of(in, p).front();
        const auto allow = [&](const std::vector<int>& candidates) {
            for (const int q : front_of(candidates, p)) {
                if (std::find(seen.allowed.begin(), seen.allowed.end(), q) == seen.allowed.end())
                    seen.allowed.push_back(q);
            }
        };
        allow(closed);
        if (on.empty()) return seen;
        for (const auto& direction : directions_between(changes_at(centre, on))) {
            std::vector<int> beside = in;
            for (const int q : on) {
                if (goes_on(at(q), centre, direction)) beside.push_back(q);
            }
            allow(beside);
        }
        return seen;
    }
};

SceneTruth::SceneTruth(const Scene& scene, Precision precision)
    : exactly_(std::make_unique<const Exactly>(scene, precision)) {}
SceneTruth::~SceneTruth() = default;

const Scene& SceneTruth::scene() const { return exactly_->scene; }

bool SceneTruth::has_inside(int polygon) const { return exactly_->at(polygon).has_inside; }

SceneTruth::Place SceneTruth::place(int polygon, double x, double y) const {
    if (!std::isfinite(x + y)) return Place::outside;
    return exactly_->place(exactly_->at(polygon), {x, y}, exactly_->slack);
}

double SceneTruth::depth(int polygon, double x, double y) const {
    if (!std::isfinite(x + y)) return std::numeric_limits<double>::quiet_NaN();
    return CGAL::to_double(exactly_->at(polygon).depth({x, y}));
}

bool SceneTruth::is_depth(int polygon, double x, double y, double z) const {
    if (!std::isfinite(x + y + z)) return false;
    const ExactPolygon& own = exactly_->at(polygon);
    // A window's corner outside the area may be farther away than any coordinate.
    const double far = std::max({1.0, std::abs(x) / exactly_->largest, std::abs(y) / exactly_->largest});
    const Rational right = own.depth({x, y});
    const bool is_right = magnitude(right - Rational(z)) <= Rational(exactly_->open(own.depth_slack * far, z));
    if (!is_right) exactly_->look_for_single(right, z, own.depth_slack * far);
    return is_right;
}

bool SceneTruth::shows_single() const { return exactly_->shows_single; }

int SceneTruth::nearer(int polygon, int than, double x, double y) const {
    const ExactPolygon &own = exactly_->at(polygon), &other = exactly_->at(than);
    const Rational before = own.depth({x, y}) - other.depth({x, y});
    if (magnitude(before) <= Rational(own.depth_slack + other.depth_slack)) return 0;
    return before > 0 ? 1 : -1;
}

bool SceneTruth::same_depth(double claimed, double right, double times) const {
    return std::abs(claimed - right) * times <= 2 * exactly_->open(exactly_->most_depth_slack(), claimed);
}

bool SceneTruth::nearly_equal(double z, double other) const {
    return std::abs(z - other) <= 2 * exactly_->most_depth_slack();
}

bool SceneTruth::equally_near(double z, double other) const {
    const double by_double = rounding(Precision::twice) / rounding(exactly_->precision);
    return std::abs(z - other) <= 2 * exactly_->most_depth_slack() * by_double;
}

bool SceneTruth::is_plane(int polygon, const std::array<double, 4>& plane) const {
    if (!std::isfinite(plane[0] + plane[1] + plane[2] + plane[3]) || plane[2] == 0) return false;
    const Rational a(plane[0]), b(plane[1]), c(plane[2]), d(plane[3]);
    const ExactPolygon& own = exactly_->at(polygon);
    double open = own.depth_slack;
    for (const double claimed : plane) open = std::min(open, exactly_->open(own.depth_slack, claimed));
    const auto holds = [&](const Point2& p) {
        const Rational z = -(a * p.x + b * p.y + d) / c;
        return magnitude(z - own.depth(p)) <= Rational(open);
    };
    return std::all_of(own.outline.begin(), own.outline.end(), holds);
}

double SceneTruth::farthest(int polygon) const {
    const auto& vertices = scene().polygons[std::size_t(polygon)].vertices;
    double least = vertices[0].z;
    for (const auto& v : vertices) least = std::min(least, v.z);
    return least;
}

PlainBox SceneTruth::box(int polygon) const {
    const auto& vertices = scene().polygons[std::size_t(polygon)].vertices;
    PlainBox box{vertices[0].x, vertices[0].y, vertices[0].x, vertices[0].y};
    for (const auto& v : vertices) {
        box = {std::min(box.xmin, v.x), std::min(box.ymin, v.y), std::max(box.xmax, v.x), std::max(box.ymax, v.y)};
    }
    return box;
}

double SceneTruth::depth_slope(int polygon) const { return CGAL::to_double(exactly_->at(polygon).zx); }

int SceneTruth::side(int polygon, int edge, double x, double y) const {
    if (!std::isfinite(x + y)) return 0;
    const auto& vertices = scene().polygons[std::size_t(polygon)].vertices;
    const auto& from = vertices[std::size_t(edge)];
    const auto& to = vertices[std::size_t(edge + 1) % vertices.size()];
    return exactly_->side_of({from.x, from.y}, {to.x, to.y}, {x, y}, exactly_->slack);
}

std::optional<SceneTruth::Crossing> SceneTruth::crossing(int polygon, int edge, double y) const {
    const auto& vertices = scene().polygons[std::size_t(polygon)].vertices;
    const auto& from = vertices[std::size_t(edge)];
    const auto& to = vertices[std::size_t(edge + 1) % vertices.size()];
    if (from.y == to.y || !std::isfinite(y)) return std::nullopt;
    const Rational x = Rational(from.x) + (Rational(y) - Rational(from.y)) * (Rational(to.x) - Rational(from.x)) /
                                              (Rational(to.y) - Rational(from.y));
    const ExactPolygon& own = exactly_->at(polygon);
    return Crossing{CGAL::to_double(x), own.has_inside ? CGAL::to_double(own.depth({x, y})) : 0};
}

std::optional<SceneTruth::Ends> SceneTruth::ends(int polygon, double y) const {
    const auto& vertices = scene().polygons[std::size_t(polygon)].vertices;
    std::optional<Ends> found;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto& [y0, y1] = std::minmax(vertices[i].y, vertices[(i + 1) % vertices.size()].y);
        const auto at = crossing(polygon, int(i), y);
        if (!at || y < y0 || y > y1) continue;
        if (!found) found.emplace(*at, *at);
        if (at->x < found->first.x) found->first = *at;
        if (at->x > found->second.x) found->second = *at;
    }
    return found;
}

// On a nearly horizontal edge, x changes much faster than y, which multiplies the tolerance.
bool SceneTruth::same_coordinate(double claimed, double right, double times) const {
    return std::abs(claimed - right) * times <= 64 * exactly_->open(exactly_->slack, claimed);
}

double SceneTruth::coincidence() const { return 64 * exactly_->slack; }

bool SceneTruth::meets(int polygon, const Window& window) const {
    const ExactPolygon& own = exactly_->at(polygon);
    if (!own.has_inside) return false;
    return twice_area(part_of(own.outline, window)) >
           Rational(exactly_->slack) * Rational(window.width + window.height);
}

bool SceneTruth::holds(int polygon, const Window& window) const {
    for (const double x : {window.x, window.right()}) {
        for (const double y : {window.y, window.bottom()}) {
            if (place(polygon, x, y) == Place::outside) return false;
        }
    }
    return true;
}

Window SceneTruth::in_area(const Window& window) const {
    const Area& area = scene().area;
    const double left = std::max(window.x, double(area.x)), top = std::max(window.y, double(area.y));
    return {left, top, std::max(0.0, std::min(window.right(), double(area.right())) - left),
            std::max(0.0, std::min(window.bottom(), double(area.bottom())) - top)};
}

std::optional<int> SceneTruth::nearer_in(int polygon, const Window& window) const {
    const ExactPolygon& own = exactly_->at(polygon);
    for (int q = 0; q < int(exactly_->polygons.size()); ++q) {
        if (q == polygon || !meets(q, window)) continue;
        const ExactPolygon& other = exactly_->at(q);
        const Rational open(own.depth_slack + other.depth_slack);
        for (const Point2& p : part_of(other.outline, window)) {
            if (other.depth(p) > own.depth(p) + open) return q;
        }
    }
    return std::nullopt;
}

bool SceneTruth::has_vertex(int polygon, const glm::dvec3& v) const {
    const ExactPolygon& own = exactly_->at(polygon);
    if (!own.has_inside) return true;
    return has_point(polygon, v.x, v.y) && std::isfinite(v.z) &&
           magnitude(own.depth({v.x, v.y}) - Rational(v.z)) <= Rational(64 * exactly_->open(own.depth_slack, v.z));
}

std::optional<std::string> SceneTruth::no_part(int polygon, const Window& window,
                                               const std::vector<glm::dvec3>& vertices, const Words& say) const {
    const ExactPolygon& own = exactly_->at(polygon);
    if (!own.has_inside) return std::nullopt;
    double open = 64 * exactly_->slack;
    Outline2 claimed;
    for (const auto& v : vertices) {
        const std::string name = say.point(v.x, v.y, v.z);
        if (!std::isfinite(v.x + v.y + v.z)) return say({"{} is not a point", "{} — не точка"}, name);
        const double open_x = 64 * exactly_->open(exactly_->slack, v.x),
                     open_y = 64 * exactly_->open(exactly_->slack, v.y);
        open = std::min({open, open_x, open_y});
        const bool in_window = v.x >= window.x - open_x && v.x <= window.right() + open_x && v.y >= window.y - open_y &&
                               v.y <= window.bottom() + open_y;
        if (!in_window) return say({"{} lies outside the window", "{} лежит вне окна"}, name);
        if (!has_point(polygon, v.x, v.y))
            return say({"{} lies outside the polygon", "{} лежит вне многоугольника"}, name);
        if (magnitude(own.depth({v.x, v.y}) - Rational(v.z)) > Rational(64 * exactly_->open(own.depth_slack, v.z))) {
            return say({"{} is not on the polygon's plane: its depth there is {}",
                        "{} не лежит в плоскости многоугольника: его глубина там равна {}"},
                       name, depth(polygon, v.x, v.y));
        }
        claimed.push_back({v.x, v.y});
    }
    const Rational right = twice_area(part_of(own.outline, window));
    const Rational area = magnitude(twice_area(claimed));
    if (magnitude(right - area) <= Rational(open) * Rational(4 * (window.width + window.height))) return std::nullopt;
    if (claimed.empty()) {
        return say({"nothing is left of it, but its part in the window has an area of {}",
                    "от него ничего не осталось, а в окне лежит площадь {}"},
                   CGAL::to_double(right) / 2);
    }
    return say({"its area is {}, and that of the part in the window is {}", "её площадь {}, а площадь части в окне {}"},
               CGAL::to_double(area) / 2, CGAL::to_double(right) / 2);
}

double SceneTruth::area_of(const RegionLoops& region) {
    double twice = 0;
    for (const auto& loop : region) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const ValuePoint &p = loop[i], &q = loop[(i + 1) % loop.size()];
            twice += p.x.number * q.y.number - p.y.number * q.x.number;
        }
    }
    return twice / 2;
}

SceneTruth::Astray SceneTruth::astray(const RegionLoops& region) {
    const std::vector<Layer> layers{exactly(region)};
    return {area_where(layers, [](const auto& windings) { return windings[0] < 0; }),
            area_where(layers, [](const auto& windings) { return windings[0] > 1; })};
}

bool SceneTruth::is_in(const RegionLoops& region, double x, double y) {
    bool inside = false;
    for (const auto& loop : region) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const ValuePoint &p = loop[i], &q = loop[(i + 1) % loop.size()];
            const double py = p.y.number, qy = q.y.number;
            if ((py <= y) != (qy <= y) && x < p.x.number + (y - py) * (q.x.number - p.x.number) / (qy - py))
                inside = !inside;
        }
    }
    return inside;
}

double SceneTruth::common_area(const RegionLoops& region, const RegionLoops& other) const {
    if (exactly_->apart(region, other) || exactly_->apart(other, region)) return 0;
    return area_where({exactly(region), exactly(other)},
                      [](const auto& windings) { return windings[0] != 0 && windings[1] != 0; });
}

SceneTruth::PartsAstray SceneTruth::parts_astray(const RegionLoops& whole, const RegionLoops& clip,
                                                 const RegionLoops& inside, const RegionLoops& outside) {
    // A part is judged by what of it is missing, and what is too much.
    const auto astray = [&](const RegionLoops& part, bool is_inside) {
        return area_where({exactly(whole), exactly(clip), exactly(part)}, [&](const auto& windings) {
            return (windings[0] != 0 && (windings[1] != 0) == is_inside) != (windings[2] != 0);
        });
    };
    return {astray(inside, true), astray(outside, false)};
}

double SceneTruth::area_in(int polygon, const Window& window) const {
    return CGAL::to_double(twice_area(part_of(exactly_->at(polygon).outline, window))) / 2;
}

/// In double it covers slivers that a program drops, too.
bool SceneTruth::same_area(double claimed, double right, bool in_floats) const {
    const Area& area = scene().area;
    const bool is_single = exactly_->precision == Precision::single && in_floats;
    const double open = is_single ? 4 * rounding(Precision::single) : 64 * rounding(Precision::twice);
    return std::abs(claimed - right) <=
           open * exactly_->largest * (area.width + area.height) * double(scene().polygons.size() + 1);
}

bool SceneTruth::in_floats(const RegionLoops& region) {
    return std::all_of(region.begin(), region.end(), [](const auto& loop) {
        return std::all_of(loop.begin(), loop.end(),
                           [](const ValuePoint& p) { return is_float(p.x.number) && is_float(p.y.number); });
    });
}

bool SceneTruth::has_point(int polygon, double x, double y) const {
    const ExactPolygon& own = exactly_->at(polygon);
    const double open = std::min(exactly_->open(exactly_->slack, x), exactly_->open(exactly_->slack, y));
    return std::isfinite(x + y) && exactly_->place(own, {x, y}, 64 * open) != Place::outside;
}

std::optional<std::pair<int, double>> SceneTruth::hidden_by(int polygon, const RegionLoops& region) const {
    const ExactPolygon& own = exactly_->at(polygon);
    for (int q = 0; q < int(exactly_->polygons.size()); ++q) {
        const ExactPolygon& other = exactly_->at(q);
        if (q == polygon || !other.has_inside) continue;
        // Clipping a loop by half-planes leaves edges that run back and forth along the clipping lines. They add no
        // area.
        Rational twice(0);
        for (Outline2 part : exactly(region)) {
            for (std::size_t i = 0; i < other.outline.size() && !part.empty(); ++i) {
                const Point2 &from = other.outline[i], &to = other.outline[(i + 1) % other.outline.size()];
                part = half_of(part, [&](const Point2& p) { return cross(from, to, p); });
            }
            const Rational open(own.depth_slack + other.depth_slack);
            part = half_of(part, [&](const Point2& p) { return Rational(other.depth(p) - own.depth(p) - open); });
            twice += twice_area(part);
        }
        const double hidden = std::abs(CGAL::to_double(twice)) / 2;
        if (!same_area(hidden, 0, in_floats(region))) return std::pair(q, hidden);
    }
    return std::nullopt;
}

double SceneTruth::covered_area() const {
    Layer parts;
    for (const auto& polygon : exactly_->polygons) {
        if (polygon.has_inside) parts.push_back(part_of(polygon.outline, whole_area(scene().area)));
    }
    return area_where({parts}, [](const auto& windings) { return windings[0] != 0; });
}

const SeenPixel& SceneTruth::seen(int column, int row) const {
    const auto [found, is_new] = exactly_->pixels.try_emplace({column, row});
    if (is_new) found->second = exactly_->see(column, row);
    return found->second;
}

Color SceneTruth::color_of(int polygon) const {
    return polygon == SeenPixel::background ? scene().background : scene().polygons[std::size_t(polygon)].color;
}

bool SceneTruth::allows(int column, int row, Color color) const {
    const auto& allowed = seen(column, row).allowed;
    return std::any_of(allowed.begin(), allowed.end(), [&](int q) { return color_of(q) == color; });
}

std::string in_words(double value) {
    Text text;
    append_number(text, value);
    return text.string();
}

std::string in_words(Color color) { return hex_of(color); }

std::string in_words(const Window& window) {
    return in_words(window.x) + " " + in_words(window.y) + " " + in_words(window.width) + " " + in_words(window.height);
}

}  // namespace vidno
