#include "say/scene_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "format/rational_text.h"
#include "scene/rational_curves.h"
#include "scene/rational_polygon.h"
#include "vidno/kernels/machine.h"

namespace vidno {

namespace {

using PointInPlane = Point<Rational>;

std::optional<Rational> in_rationals(const Value& value) {
    if (!value.fraction) return std::isfinite(value.number) ? std::optional<Rational>(value.number) : std::nullopt;
    return rational_in(*value.fraction);
}

std::optional<PointInPlane> in_rationals(const ValuePoint& point) {
    const auto x = in_rationals(point.x), y = in_rationals(point.y);
    return x && y ? std::optional(PointInPlane{*x, *y}) : std::nullopt;
}

Value as_value(const Rational& number) { return Value(Exact::fraction(number)); }

std::array<PointInPlane, 4> corners_of(const Window& window) {
    return {PointInPlane{window.x, window.y}, PointInPlane{window.x, window.bottom()},
            PointInPlane{window.right(), window.y}, PointInPlane{window.right(), window.bottom()}};
}
/// The centres of the pixels at the corners.
std::array<PointInPlane, 4> corners_of(const PixelRectangle& pixels) {
    return corners_of(Window{pixels.x + .5, pixels.y + .5, pixels.width - 1., pixels.height - 1.});
}

/// Whether the polygon hides the other at a point that both hold; `comes_first`: so it does in the scene.
bool hides(const RationalPolygon& polygon, const RationalPolygon& other, bool comes_first, const PointInPlane& at) {
    const Rational own = polygon.depth(at), others = other.depth(at);
    return own > others || (own == others && comes_first);
}

/// A polygon that may show in a rectangle of pixels, and whether it holds all of their centres.
struct Candidate {
    int place;
    const RationalPolygon* polygon;
    bool holds = false;
};

using Corners = std::array<PointInPlane, 4>;

/// Whether an edge separates the corners from the polygon. Otherwise it finds whether the polygon holds them.
bool is_separate(Candidate& candidate, const Corners& corners) {
    candidate.holds = true;
    for (std::size_t edge = 0; edge < candidate.polygon->vertices.size(); ++edge) {
        bool all_outside = true;
        for (const auto& corner : corners) {
            const bool outside = candidate.polygon->inward(edge, corner) < 0;
            candidate.holds = candidate.holds && !outside;
            all_outside = all_outside && outside;
        }
        if (all_outside) return true;
    }
    return false;
}

/// Leaves out the polygons that do not show in the rectangle: those beside it, and those behind one that holds it.
void leave_out_hidden(std::vector<Candidate>& candidates, const Corners& corners) {
    std::erase_if(candidates, [&](Candidate& each) { return !each.holds && is_separate(each, corners); });
    const Candidate* front = nullptr;
    for (const Candidate& each : candidates) {
        if (each.holds && (!front || hides(*each.polygon, *front->polygon, false, corners[0]))) front = &each;
    }
    if (!front) return;
    const Candidate nearest = *front;
    std::erase_if(candidates, [&](const Candidate& each) {
        return each.place != nearest.place && std::all_of(corners.begin(), corners.end(), [&](const auto& corner) {
                   return hides(*nearest.polygon, *each.polygon, nearest.place < each.place, corner);
               });
    });
}

std::optional<SceneFacts::Shown> unexpected_among(std::vector<Candidate> candidates, const PixelRectangle& pixels,
                                                  const std::function<bool(std::optional<int>)>& expected) {
    leave_out_hidden(candidates, corners_of(pixels));
    const auto [x, y, width, height] = pixels;
    if (candidates.empty() || (candidates.size() == 1 && candidates[0].holds)) {
        const auto owner = candidates.empty() ? std::nullopt : std::optional(candidates[0].place);
        return expected(owner) ? std::nullopt : std::optional(SceneFacts::Shown{x, y, owner});
    }
    const bool is_wide = width >= height;
    const PixelRectangle first =
        is_wide ? PixelRectangle{x, y, width / 2, height} : PixelRectangle{x, y, width, height / 2};
    const PixelRectangle rest = is_wide ? PixelRectangle{x + width / 2, y, width - width / 2, height}
                                        : PixelRectangle{x, y + height / 2, width, height - height / 2};
    const auto found = unexpected_among(candidates, first, expected);
    return found ? found : unexpected_among(std::move(candidates), rest, expected);
}

}  // namespace

struct SceneFacts::Polygons : RationalPolygons {
    bool edge_on_shows;

    /// Those of the first polygons whose boxes meet the window. None if what shows there is not known.
    std::optional<std::vector<Candidate>> near(const Window& window, int polygons) {
        std::vector<Candidate> found;
        for (int place = 0; place < polygons; ++place) {
            if (Double{}.outside(box(place), window)) continue;
            if (!at(place).is_edge_on()) {
                found.push_back({place, &at(place)});
            } else if (edge_on_shows) {
                return std::nullopt;
            }
        }
        return found;
    }
};

SceneFacts::SceneFacts(const TraceHeader& header)
    : polygons_(std::make_unique<Polygons>(
          Polygons{RationalPolygons(header.scene), header.method == Method::warnock_edges})) {}
SceneFacts::~SceneFacts() = default;

std::optional<bool> SceneFacts::holds(int polygon, const ValuePoint& at) const {
    const auto place = in_rationals(at);
    if (!place || (polygons_->edge_on_shows && is_edge_on(polygon))) return std::nullopt;
    return polygons_->at(polygon).holds(*place);
}

std::optional<Value> SceneFacts::cross(int polygon, int edge, const ValuePoint& at) const {
    const auto place = in_rationals(at);
    if (!place) return std::nullopt;
    return as_value(polygons_->at(polygon).cross(std::size_t(edge), *place));
}

std::optional<Value> SceneFacts::depth(int polygon, const ValuePoint& at) const {
    const auto place = in_rationals(at);
    if (!place || is_edge_on(polygon)) return std::nullopt;
    return as_value(polygons_->at(polygon).depth(*place));
}

std::optional<std::pair<Value, Value>> SceneFacts::on_row(int polygon, int row) const {
    const auto& vertices = polygons_->at(polygon).vertices;
    const Rational y(row + .5);
    std::optional<std::pair<Rational, Rational>> found;
    const auto add = [&](const Rational& x) {
        if (!found) {
            found.emplace(x, x);
        } else if (x < found->first) {
            found->first = x;
        } else if (x > found->second) {
            found->second = x;
        }
    };
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto &p = vertices[i], &q = vertices[(i + 1) % vertices.size()];
        if (p.y == y) add(p.x);
        if ((p.y < y && q.y > y) || (p.y > y && q.y < y)) add(p.x + (q.x - p.x) * (y - p.y) / (q.y - p.y));
    }
    if (!found) return std::nullopt;
    return std::pair(as_value(found->first), as_value(found->second));
}

bool SceneFacts::is_edge_on(int polygon) const { return polygons_->at(polygon).is_edge_on(); }

bool SceneFacts::is_box_outside(int polygon, const Window& window) const {
    return Double{}.outside(polygons_->at(polygon).box, window);
}

bool SceneFacts::is_box_inside(int polygon, const Window& window) const {
    return Double{}.inside(polygons_->at(polygon).box, window);
}

std::optional<Relation> SceneFacts::relation(int polygon, const Window& window) const {
    if (is_edge_on(polygon)) return std::nullopt;
    const RationalPolygon& own = polygons_->at(polygon);
    const auto corners = corners_of(window);
    const auto& [xmin, ymin, xmax, ymax] = own.box;
    if (is_box_outside(polygon, window)) return Relation::outside;
    bool holds_all = true, touches = false;
    for (std::size_t edge = 0; edge < own.vertices.size(); ++edge) {
        int outside = 0, on_line = 0;
        for (const auto& corner : corners) {
            const Rational side = own.inward(edge, corner);
            outside += side < 0 ? 1 : 0;
            on_line += side == 0 ? 1 : 0;
        }
        if (outside == 4) return Relation::outside;
        holds_all = holds_all && outside == 0;
        touches = touches || outside + on_line == 4;
    }
    touches = touches || xmax == window.x || ymax == window.y || xmin == window.right() || ymin == window.bottom();
    if (touches) return std::nullopt;
    if (holds_all) return Relation::surrounding;
    if (is_box_inside(polygon, window)) return Relation::inside;
    const bool is_within = xmin >= window.x && ymin >= window.y && xmax <= window.right() && ymax <= window.bottom();
    return is_within ? std::nullopt : std::optional(Relation::intersecting);
}

std::optional<SceneFacts::Shown> SceneFacts::shown(int x, int y) const {
    return unexpected({x, y, 1, 1}, [](std::optional<int>) { return false; });
}

std::optional<SceneFacts::Seen> SceneFacts::seen(const ValuePoint& at) const {
    const auto place = in_rationals(at);
    if (!place) return std::nullopt;
    const double x = number_of(at.x), y = number_of(at.y);
    const auto near = polygons_->near({std::floor(x), std::floor(y), 1, 1}, polygons_->count());
    if (!near) return std::nullopt;
    std::optional<int> nearest;
    for (const auto& [i, polygon, holds] : *near) {
        if (polygon->holds(*place) && !(nearest && hides(polygons_->at(*nearest), *polygon, true, *place))) nearest = i;
    }
    return Seen{nearest};
}

std::optional<SceneFacts::Shown> SceneFacts::unexpected(const PixelRectangle& pixels,
                                                        const std::function<bool(std::optional<int>)>& expected) const {
    return unexpected(pixels, polygons_->count(), expected);
}

std::optional<SceneFacts::Shown> SceneFacts::unexpected(const PixelRectangle& pixels, int polygons,
                                                        const std::function<bool(std::optional<int>)>& expected) const {
    const auto [x, y, width, height] = pixels;
    if (width <= 0 || height <= 0) return std::nullopt;
    auto near = polygons_->near({x + .5, y + .5, width - 1., height - 1.}, polygons);
    return near ? unexpected_among(std::move(*near), pixels, expected) : std::nullopt;
}

namespace {

std::optional<Rational> height_of(const Curve& curve, int x) {
    for (const Piece& piece : pieces_of(curve)) {
        for (std::size_t i = 1; i < piece.size(); ++i) {
            if (piece[i - 1].x <= x && x <= piece[i].x) return height_on(piece[i - 1], piece[i], x);
        }
    }
    return std::nullopt;
}

/// The height of a side edge over a column strictly between its ends.
std::optional<Rational> height_of_edge(const Sample& from, const Sample& to, int x) {
    const auto [first, end] = columns_of_edge(from, to);
    return first <= x && x < end ? std::optional(height_on(from, to, x)) : std::nullopt;
}

/// The heights of the horizons over a column. Heights grow downward, so the upper one is the least.
struct ReachedHeights {
    Rational upper, lower;

    const Rational& on(VisibilityFlag side) const { return side == VisibilityFlag::above ? upper : lower; }
};

std::optional<ReachedHeights> reached_before(const CurveScene& scene, int curve, int x) {
    std::optional<ReachedHeights> reached;
    const auto include = [&](const std::optional<Rational>& y) {
        if (!y) return;
        if (!reached) reached = ReachedHeights{*y, *y};
        if (*y < reached->upper) reached->upper = *y;
        if (*y > reached->lower) reached->lower = *y;
    };
    std::optional<std::pair<Sample, Sample>> last;
    for (std::size_t each = 0;; ++each) {
        const Curve& next = scene.curves[each];
        const auto ends = ends_of(next);
        // A curve's left edge is before it, its right one after it.
        if (last && ends) include(height_of_edge(last->first, ends->first, x));
        if (each == std::size_t(curve)) return reached;
        include(height_of(next, x));
        if (last && ends) include(height_of_edge(last->second, ends->second, x));
        last = ends;
    }
}

}  // namespace

std::optional<Value> CurveFacts::height(int curve, int x) const {
    const auto y = height_of(scene_->curves[std::size_t(curve)], x);
    return y ? std::optional(as_value(*y)) : std::nullopt;
}

std::optional<CurveFacts::Reached> CurveFacts::horizons(int curve, int x) const {
    const auto reached = reached_before(*scene_, curve, x);
    return reached ? std::optional(Reached{as_value(reached->upper), as_value(reached->lower)}) : std::nullopt;
}

std::optional<VisibilityFlag> CurveFacts::flag(int curve, int x) const {
    using enum VisibilityFlag;
    const auto y = height_of(scene_->curves[std::size_t(curve)], x);
    if (!y) return std::nullopt;
    const auto reached = reached_before(*scene_, curve, x);
    if (!reached) return both;
    const bool reaches_upper = *y <= reached->upper, reaches_lower = *y >= reached->lower;
    if (reaches_upper && reaches_lower) return both;
    if (reaches_upper) return above;
    return reaches_lower ? below : hidden;
}

std::optional<ValuePoint> CurveFacts::crossing(int curve, int x, VisibilityFlag side) const {
    const Curve& own = scene_->curves[std::size_t(curve)];
    const auto left = height_of(own, x), right = height_of(own, x + 1);
    const auto from = reached_before(*scene_, curve, x), to = reached_before(*scene_, curve, x + 1);
    if (!left || !right || !from || !to) return std::nullopt;
    const Rational first = *left - from->on(side), last = *right - to->on(side);
    if (first == 0 || last == 0 || (first < 0) == (last < 0)) return std::nullopt;
    const Rational t = first / (first - last);
    return ValuePoint{as_value(Rational(x) + t), as_value(*left + t * (*right - *left))};
}

}  // namespace vidno
