/// FilterExactly: what exact arithmetic decides for the kernel `filtered`, since the bounds of the doubles leave it
/// open. It takes the given numbers that the doubles approximate.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cassert>
#include <numeric>
#include <utility>
#include <vector>

#include "filter_bounds.h"
#include "filtered_values.h"

namespace vidno {

struct FilterExactly : FilterBounds {
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
    // Pure, so that runs without a visitor, which need no slope, do not call it.
    [[gnu::noinline, gnu::pure]] static bool exactly_same_place(const auto& a, const auto& b, int row) noexcept {
        return exact_x(a, row) == exact_x(b, row);
    }
    static Rational exact_slope(const auto& edge) {
        return (Rational(edge.lower.x.value) - Rational(edge.upper.x.value)) /
               (Rational(edge.lower.y.value) - Rational(edge.upper.y.value));
    }

    static constexpr Exact exact_{};
};

}  // namespace vidno
