/// Filtered: decisions that are always right, at nearly the cost of doubles.
///
/// The doubles decide where the bound on their error allows it. Elsewhere exact arithmetic decides, from what the
/// doubles stand for: a polygon's plane at a point, its edge at a row or at a side of a window. No rounded value
/// decides, so errors do not accumulate. A trace shows the doubles.
///
/// Source  On the bound of the cross product: J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast
///         robust geometric predicates, Discrete & Computational Geometry 18, 1997. Where it does not decide: CGAL's
///         predicate.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "filter_exactly.h"
#include "filtered_values.h"

namespace vidno {

/// `Tally` receives, for each comparison, what decided it.
template <class Tally>
class FilteredBy : public PlaneDepths<FilteredPlane, Tally>, protected FilterExactly {
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
        // Shewchuk's bound, 3 roundoffs of the sum of the products, each at most (2 extent)^2, is 12 of these units.
        // Hardly more are needed, since the last subtraction, which may round by 4, keeps the sign; 16 is the next
        // power of two. tests/bounds has the proof.
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
            return {value, std::signbit(value) ? Sign::negative : Sign::positive};
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

    /// Two neighbours on an earlier side have its x or y, which one of them got when it was cut there. Otherwise both
    /// are on p's edge.
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
        const auto first = first_after(edge.x, low, end);
        if (!first) return close_first_column(edge, row, low, end);
        tell(true);
        return *first;
    }
    int last_column(const auto& edge, int row, int low, int end) const {
        const auto first = first_after(edge.x, low, end);
        if (!first) return close_last_column(edge, row, low, end);
        tell(true);
        return *first - 1;
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

private:
    /// The cross product left - right, which the scene's bound does not decide. Apart, so that the compiler inlines
    /// `cross`.
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

    /// For an edge that is exactly or nearly at a centre. Apart for the same reason.
    [[gnu::noinline]] int close_first_column(const auto& edge, int row, int low, int end) const {
        const auto certain = certain_first(edge.x, low, end);
        tell(certain.has_value());
        return certain ? *certain : exact_first_column(edge, row, low, end);
    }
    [[gnu::noinline]] int close_last_column(const auto& edge, int row, int low, int end) const {
        const auto certain = certain_last(edge.x, low, end);
        tell(certain.has_value());
        return certain ? *certain : exact_last_column(edge, row, low, end);
    }

    /// Reports whether the bound of the operands decided, or exact arithmetic.
    void tell(bool certain) const { tell(certain ? FilterStage::operands : FilterStage::exact); }
    using Depths::tell;

    bool same(const Bounded& a, const Bounded& b, auto&& exactly_so) const {
        const bool apart = std::abs(a.value - b.value) > 2 * (a.error + b.error);
        const bool known = apart || (a.is_exact() && b.is_exact());
        tell(known);
        return known ? !apart : exactly_so();
    }

    double extent_ = 0;
    double cross_error_ = infinity;
};

using Filtered = FilteredBy<NoTally>;

}  // namespace vidno
