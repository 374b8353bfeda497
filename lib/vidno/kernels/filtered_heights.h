/// The kernel `filtered` for the floating horizon: a height is a double with a bound, and the segment that it belongs
/// to.
///
/// The doubles decide which of two heights is greater where the bounds allow it, otherwise the segments in exact
/// arithmetic.
#pragma once

#include <cassert>
#include <cmath>

#include "../floating_horizon/floating_horizon_kernel.h"
#include "filtered.h"

namespace vidno {

template <class Tally>
struct OnColumns<FilteredBy<Tally>> : FilteredBy<Tally> {
    using Number = Bounded;

    /// The height of a segment over a column.
    struct Height {
        Bounded y;
        Segment segment;
        int column;

        explicit operator double() const { return y.value; }
        Rational exactly() const { return exact_.height(segment, column); }
    };

    OnColumns() = default;
    explicit OnColumns(FilteredBy<Tally> kernel) : FilteredBy<Tally>(std::move(kernel)) {}

    Height height(const Segment& segment, int column) const {
        return {bounded_.height(segment, column), segment, column};
    }

    Point<Bounded> point_on(const Segment& segment, int column) const { return bounded_.point_on(segment, column); }

    Sign compare(const Height& a, const Height& b) const {
        assert(a.column == b.column);
        const Bounded above = b.y - a.y;
        if (sign_is_certain(above)) {
            tell(FilterStage::operands);
            return Sign{above.value > 0 ? 1 : -1};
        }
        const bool both_exact = a.y.is_exact() && b.y.is_exact();
        if (a.segment == b.segment || (both_exact && a.y.value == b.y.value)) {
            tell(FilterStage::given);
            return Sign::zero;
        }
        tell(FilterStage::exact);
        return exact_.compare(a.exactly(), b.exactly());
    }

    /// For display only: comparisons use the segments. It is computed exactly and rounded where the bounds do not place
    /// it between the columns, or leave a visible uncertainty.
    Point<Bounded> crossing(const Segment& segment, int column, const Height& h1, const Height& h2) const {
        const auto near = bounded_.crossing(segment, column, h1.y, h2.y);
        const bool between = near.x.low() > column && near.x.high() < column + 1;
        if (between && near.x.error < invisible && near.y.error < invisible) return near;
        const auto exact = exact_.crossing(segment, column, h1.exactly(), h2.exactly());
        return {rounded(exact.x), rounded(exact.y)};
    }

private:
    static constexpr double invisible = 0x1p-20;  // of a pixel

    /// Bounded numbers for the formulas; their comparisons are not used.
    struct BoundedNumbers {
        using Number = Bounded;
        Bounded number(double given) const { return given; }
    };

    /// CGAL rounds by at most an ulp.
    static Bounded rounded(const Rational& value) {
        const double near = CGAL::to_double(value);
        return {near, 2 * Bounded::unit * std::abs(near) + Bounded::underflow};
    }

    void tell(FilterStage stage) const { PlaneDepths<FilteredPlane, Tally>::tell(stage); }

    static constexpr OnColumns<BoundedNumbers> bounded_{};
    static constexpr OnColumns<Exact> exact_{};
};

}  // namespace vidno
