/// Filtered: decisions that are always right, at nearly the cost of doubles.
///
/// The doubles decide where the bound on their error allows it. Elsewhere exact arithmetic decides on what they represent: a
/// polygon's plane at a point, its edge at a row or at a side of a window. No rounded value decides, so errors do not
/// accumulate. A trace shows the doubles.
///
/// Source  On the bound of the cross product: J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust
///         geometric predicates, Discrete & Computational Geometry 18, 1997. Where it does not decide: CGAL's predicate.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "filtered_values.h"

namespace vidno {

/// `Tally` receives, for each comparison, what decided it.
template <class Tally>
class FilteredBy : public PlaneDepths<FilteredPlane, Tally> {
    using Depths = PlaneDepths<FilteredPlane, Tally>;
    using Depths::infinity;

public:
    using Coordinate = Given;
    using Number = Bounded;
    using Plane = FilteredPlane;
    using Outline = std::vector<ClippedVertex>;

    static constexpr std::string_view name = "filtered";

    explicit FilteredBy(Tally tally = {}) : Depths(tally) {}

    void see(const Scene& scene) {
        extent_ = farthest_out(scene);
        // Shewchuk's bound, 3 roundoffs of the sum of the products, each at most (2 extent)^2, and a margin.
        cross_error_ = 16 * extent_ * extent_ * Bounded::unit;
        Depths::expect_planes(scene.polygons.size());
    }

    Vertex<Given> vertex(const glm::dvec3& v) const { return {{v.x}, {v.y}, {v.z}}; }
    Point<Given> point(double x, double y) const { return {{x}, {y}}; }
    Given centre(int pixel) const { return {pixel + 0.5}; }

    Sign sign(const FilteredCross& cross) const { return cross.sign; }

    FilteredCross cross(const auto& pivot, const auto& a, const auto& b) const {
        const double left = (a.x.value - pivot.x.value) * (b.y.value - pivot.y.value);
        const double right = (a.y.value - pivot.y.value) * (b.x.value - pivot.x.value);
        const double value = left - right;
        if (std::abs(value) > cross_error_) {
            tell(FilterStage::scene);
            return {value, sign_of(value)};
        }
        return cross_near_zero(left, right, pivot, a, b);
    }

    SideCross cross(const Point<Given>& pivot, const ClippedVertex& a, const Point<Given>& b) const {
        const double value = (a.x.value - pivot.x.value) * (b.y.value - pivot.y.value) -
                             (a.y.value - pivot.y.value) * (b.x.value - pivot.x.value);
        const bool vertical = pivot.x == b.x;
        const Given at = vertical ? pivot.x : pivot.y;
        const auto certain = certain_sign((vertical ? a.x : a.y) - at);
        tell(certain.has_value());
        const Sign beyond = certain ? *certain : exact_sign_beyond(a, vertical, at.value);
        const bool same_way = vertical ? b.y > pivot.y : b.x < pivot.x;
        return {{value, same_way ? beyond : -beyond}, vertical, at.value};
    }

    Plane plane(const vidno::Plane<Bounded>& computed, const std::vector<Vertex<Given>>& vertices) {
        const Bounded x_slope = -computed.a / computed.c;
        const Bounded y_slope = -computed.b / computed.c;
        const Bounded at_origin = -computed.d / computed.c;
        const Bounded farthest_out(extent_);
        const auto greatest = [](const Bounded& v) { return Bounded(std::abs(v.value), v.error); };
        const Bounded depth =
            greatest(x_slope) * farthest_out + (greatest(y_slope) * farthest_out + greatest(at_origin));
        Plane plane;
        plane.x_slope = x_slope.value;
        plane.y_slope = y_slope.value;
        plane.at_origin = at_origin.value;
        plane.error = at_most(depth.error);
        plane.a = computed.a.value;
        plane.b = computed.b.value;
        plane.c = computed.c.value;
        plane.d = computed.d.value;
        plane.vertices = vertices;
        return Depths::keep(plane, vertices);
    }

    bool outside(const Box<Given>& box, const Window& window) const {
        tell(FilterStage::given);
        return box.xmax.value < window.x || box.ymax.value < window.y || box.xmin.value > window.right() ||
               box.ymin.value > window.bottom();
    }
    bool inside(const Box<Given>& box, const Window& window) const {
        tell(FilterStage::given);
        return box.xmin.value > window.x && box.ymin.value > window.y && box.xmax.value < window.right() &&
               box.ymax.value < window.bottom();
    }

    Outline outline(const std::vector<Vertex<Given>>& vertices) const {
        Outline outline;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto& v = vertices[i];
            outline.push_back({v.x, v.y, v.z.value, &v, &vertices[(i + 1) % vertices.size()]});
        }
        return outline;
    }

    /// Two neighbours on an earlier side have its x or y, which one of them got when it was cut there. Otherwise both are on p's edge.
    ClippedVertex meet(const ClippedVertex& p, const ClippedVertex& q, const SideCross& cp, const SideCross& cq) const {
        const double t = cp.value / (cp.value - cq.value);
        ClippedVertex found{cp.at, cp.at, p.z + (q.z - p.z) * t, p.from, p.to};
        const auto& a = *p.from;
        const auto& b = *p.to;
        if (cp.vertical) {
            const bool level = same(p.y, q.y, [&] { return exactly(p).y == exactly(q).y; });
            found.y = level ? exact_one(p.y, q.y) : a.y + (Given{cp.at} - a.x) * (b.y - a.y) / (b.x - a.x);
        } else {
            const bool upright = same(p.x, q.x, [&] { return exactly(p).x == exactly(q).x; });
            found.x = upright ? exact_one(p.x, q.x) : a.x + (Given{cp.at} - a.y) * (b.x - a.x) / (b.y - a.y);
        }
        return found;
    }

    int first_centre(Given value, int low, int end) const {
        tell(FilterStage::given);
        return machine_.first_centre(value.value, low, end);
    }
    int last_centre(Given value, int low, int end) const {
        tell(FilterStage::given);
        return machine_.last_centre(value.value, low, end);
    }

    Rows rows_of(const auto& outline, int low, int end) const {
        Range top, bottom;
        for (const auto& v : outline) {
            top.least(v.y);
            bottom.greatest(v.y);
        }
        const auto first = certain_first(top, low, end);
        const auto last = certain_last(bottom, low, end);
        tell(first && last);
        if (first && last) return {*first, *last + 1};
        return exact_.rows_of(exactly(outline), low, end);
    }

    Columns<double> columns_of(const auto& outline, int row, int low, int end) const {
        const Given y = centre(row);
        Range left, right;
        bool certain = true;
        const auto include = [&](const Bounded& x) {
            left.least(x);
            right.greatest(x);
        };
        const auto* from = &outline.back();
        auto from_side = certain_sign(from->y - y);
        for (const auto& to : outline) {
            const auto to_side = certain_sign(to.y - y);
            if (to_side && from_side) {
                if (*to_side == Sign::zero) include(to.x);
                if (*to_side != Sign::zero && *from_side == -*to_side) {
                    include(from->x + (y - from->y) * (to.x - from->x) / (to.y - from->y));
                }
            } else {
                certain = false;
            }
            from = &to;
            from_side = to_side;
        }
        if (certain && left.empty()) {
            tell(true);
            return {1, 0, low, low};
        }
        const auto first = certain_first(left, low, end);
        const auto last = certain_last(right, low, end);
        certain = certain && first && last;
        tell(certain);
        if (certain) return {left.value, right.value, *first, *last + 1};
        const auto exact = exact_.columns_of(exactly(outline), row, low, end);
        return {CGAL::to_double(exact.left), CGAL::to_double(exact.right), exact.first, exact.end};
    }

    /// The x of a vertex of the scene is given, that of an active edge is computed.
    template <class Z>
    int first_column(const Vertex<Given, Z>& end_point, int, int low, int end) const {
        tell(true);
        return machine_.first_centre(end_point.x.value, low, end);
    }
    template <class Z>
    int last_column(const Vertex<Given, Z>& end_point, int, int low, int end) const {
        tell(true);
        return machine_.last_centre(end_point.x.value, low, end);
    }
    int first_column(const auto& edge, int row, int low, int end) const {
        const auto certain = certain_first(edge.x, low, end);
        tell(certain.has_value());
        return certain ? *certain : exact_first_column(edge, row, low, end);
    }
    int last_column(const auto& edge, int row, int low, int end) const {
        const auto certain = certain_last(edge.x, low, end);
        tell(certain.has_value());
        return certain ? *certain : exact_last_column(edge, row, low, end);
    }
    bool same_place(const auto& a, const auto& b, int row) const {
        return same(a.x, b.x, [&] { return exactly_same_place(a, b, row); });
    }
    bool left_of(const auto& a, const auto& b, int row) const {
        const auto certain = certain_sign(a.x - b.x);
        const bool apart = certain && *certain != Sign::zero;
        tell(apart);
        if (apart) return *certain == Sign::negative;
        const Rational ax = exact_x(a, row);
        const Rational bx = exact_x(b, row);
        return ax < bx || (ax == bx && exact_slope(a) < exact_slope(b));
    }

protected:
    /// The first of low <= i < end for which that does not hold, `end` if there is none; it holds for all before.
    static int first_not(const auto& holds, int low, int end) {
        while (low < end) {
            const int middle = std::midpoint(low, end);
            if (holds(middle)) {
                low = middle + 1;
            } else {
                end = middle;
            }
        }
        return low;
    }

private:
    /// The cross product left - right, which the scene's bound does not decide. Apart, so that the compiler inlines `cross`.
    [[gnu::noinline]] FilteredCross cross_near_zero(double left, double right, const auto& pivot, const auto& a,
                                                    const auto& b) const {
        const double value = left - right;
        const double error = 2 * Bounded::unit * (std::abs(left) + std::abs(right)) + Bounded::underflow;
        if (std::abs(value) > error) {
            tell(FilterStage::operands);
            return {value, sign_of(value)};
        }
        tell(FilterStage::exact);
        return {value, exact_orientation(pivot, a, b)};
    }

    /// Reports whether the bound of the operands decided, or exact arithmetic.
    void tell(bool certain) const { tell(certain ? FilterStage::operands : FilterStage::exact); }
    using Depths::tell;

    // ------------------------------------------------------------------------------------- by the bound

    /// A bound that is NaN bounds nothing.
    static double at_most(double error) { return std::isnan(error) ? infinity : error; }

    static Sign sign_of(double value) { return Sign{int(value > 0) - int(value < 0)}; }

    static std::optional<Sign> certain_sign(const Bounded& v) {
        if (sign_is_certain(v)) return sign_of(v.value);
        if (v.value == 0 && v.error == 0) return Sign::zero;
        return std::nullopt;
    }

    /// The least or the greatest of some values: the double to show, and the bounds between which the exact one lies.
    class Range {
    public:
        double value = 0;

        void least(const Bounded& v) {
            include(v, [](double a, double b) { return b < a ? b : a; });
        }
        void greatest(const Bounded& v) {
            include(v, [](double a, double b) { return a < b ? b : a; });
        }
        bool empty() const { return !any_; }
        double low() const { return known_ ? low_ : -infinity; }
        double high() const { return known_ ? high_ : infinity; }

    private:
        void include(const Bounded& v, auto&& choose) {
            known_ = known_ && std::isfinite(v.low()) && std::isfinite(v.high());
            value = any_ ? choose(value, v.value) : v.value;
            low_ = any_ ? choose(low_, v.low()) : v.low();
            high_ = any_ ? choose(high_, v.high()) : v.high();
            any_ = true;
        }

        double low_ = 0, high_ = 0;
        bool any_ = false, known_ = true;
    };

    struct Interval {
        double low, high;
    };
    static Interval interval_of(const Bounded& v) {
        const bool known = std::isfinite(v.low()) && std::isfinite(v.high());
        return known ? Interval{v.low(), v.high()} : Interval{-infinity, infinity};
    }

    /// Certain if the centres on either side of the value lie outside its bounds; never if the bounds are unknown.
    static std::optional<int> certain_first(const auto& v, int low, int end) {
        const int first = machine_.first_centre(v.value, low, end);
        const bool certain = (first == low || first - 0.5 < v.low()) && (first == end || v.high() <= first + 0.5);
        return certain ? std::optional(first) : std::nullopt;
    }
    static std::optional<int> certain_last(const auto& v, int low, int end) {
        const int last = machine_.last_centre(v.value, low, end);
        const bool certain = (last == low - 1 || last + 0.5 <= v.low()) && (last == end - 1 || v.high() < last + 1.5);
        return certain ? std::optional(last) : std::nullopt;
    }

    bool same(const Bounded& a, const Bounded& b, auto&& exactly_so) const {
        const bool apart = std::abs(a.value - b.value) > 2 * (a.error + b.error);
        const bool known = apart || (a.is_exact() && b.is_exact());
        tell(known);
        return known ? !apart : exactly_so();
    }
    static Bounded exact_one(const Bounded& a, const Bounded& b) { return a.is_exact() ? a : b; }

    // ------------------------------------------------------------------------------------- exactly

    [[gnu::noinline]] static Sign exact_orientation(const auto& pivot, const auto& a, const auto& b) {
        using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
        const auto point = [](const auto& p) { return Predicates::Point_2(p.x.value, p.y.value); };
        return Sign{int(CGAL::orientation(point(pivot), point(a), point(b)))};
    }

    static Vertex<Rational> exactly(const Vertex<Given>& v) { return {v.x.value, v.y.value, 0}; }
    static Vertex<Rational> exactly(const ClippedVertex& v) {
        assert(v.x.is_exact() || v.y.is_exact());
        // A computed coordinate may be infinite or NaN, so only an exact one becomes a rational.
        if (!v.x.is_exact()) {
            const Rational y = v.y.value;
            return {along(v.from->y, v.from->x, v.to->y, v.to->x, y), y, 0};
        }
        const Rational x = v.x.value;
        return {x, v.y.is_exact() ? Rational(v.y.value) : along(v.from->x, v.from->y, v.to->x, v.to->y, x), 0};
    }
    template <class AnyVertex>
    static std::vector<Vertex<Rational>> exactly(const std::vector<AnyVertex>& outline) {
        std::vector<Vertex<Rational>> vertices;
        for (const auto& v : outline) vertices.push_back(exactly(v));
        return vertices;
    }

    /// The line from (u1, v1) to (u2, v2) at u.
    static Rational along(Given u1, Given v1, Given u2, Given v2, const Rational& u) {
        const Rational start = u1.value;
        const Rational value = v1.value;
        return value + (u - start) * (Rational(v2.value) - value) / (Rational(u2.value) - start);
    }

    [[gnu::noinline]] static Sign exact_sign_beyond(const ClippedVertex& vertex, bool vertical, double at) {
        const auto v = exactly(vertex);
        return exact_.sign((vertical ? v.x : v.y) - Rational(at));
    }

    /// Where the end of a span lies: a vertex, or an active edge on its row.
    static Rational exact_x(const auto& end_point, int row) {
        if constexpr (requires { end_point.upper; }) {
            const auto& [upper, lower] = std::pair(end_point.upper, end_point.lower);
            return along(upper.y, upper.x, lower.y, lower.x, exact_.centre(row));
        } else {
            return Rational(end_point.x.value);
        }
    }
    /// Where an active edge passes a pixel's centre, on its row: negative on the left.
    static Sign exact_side(const auto& edge, int x, int row) {
        return exact_orientation(edge.upper, edge.lower, Point<Given>{{x + 0.5}, {row + 0.5}});
    }
    /// Decides by the side of one centre: if the bounds are known, no more than one lies between them.
    [[gnu::noinline]] static int exact_first_column(const auto& edge, int row, int low, int end) {
        const auto [left, right] = interval_of(edge.x);
        return first_not([&](int x) { return exact_side(edge, x, row) == Sign::positive; },
                         machine_.first_centre(left, low, end), machine_.first_centre(right, low, end));
    }
    [[gnu::noinline]] static int exact_last_column(const auto& edge, int row, int low, int end) {
        const auto [left, right] = interval_of(edge.x);
        return first_not([&](int x) { return exact_side(edge, x, row) != Sign::negative; },
                         machine_.last_centre(left, low, end) + 1, machine_.last_centre(right, low, end) + 1) -
               1;
    }
    [[gnu::noinline]] static bool exactly_same_place(const auto& a, const auto& b, int row) {
        return exact_x(a, row) == exact_x(b, row);
    }
    static Rational exact_slope(const auto& edge) {
        return (Rational(edge.lower.x.value) - Rational(edge.upper.x.value)) /
               (Rational(edge.lower.y.value) - Rational(edge.upper.y.value));
    }

    static constexpr NumberKernel<double> machine_{};
    static constexpr Exact exact_{};

    double extent_ = 0;
    double cross_error_ = infinity;
};

using Filtered = FilteredBy<NoTally>;

}  // namespace vidno
