/// The kernel `filtered` for Weiler and Atherton's algorithm: a constructed number is an interval and keeps its
/// operands.
///
/// The interval decides a sign where it can, otherwise the number is computed exactly. No rounded value decides.
#pragma once

#include <CGAL/Lazy_exact_nt.h>

#include <utility>

#include "../weiler_atherton/weiler_atherton_kernel.h"
#include "filtered.h"

namespace vidno {

class Constructed {
public:
    Constructed(double given = 0) : value_(given) {}

    explicit operator double() const { return interval().is_point() ? interval().inf() : nearest_double(exactly()); }

    const Rational& exactly() const { return value_.exact(); }

    Interval interval() const { return value_.approx(); }

    Constructed& operator+=(const Constructed& other) { return *this = *this + other; }

    friend Constructed operator-(const Constructed& a) { return -a.value_; }
    friend Constructed operator+(const Constructed& a, const Constructed& b) { return a.value_ + b.value_; }
    friend Constructed operator-(const Constructed& a, const Constructed& b) { return a.value_ - b.value_; }
    friend Constructed operator*(const Constructed& a, const Constructed& b) { return a.value_ * b.value_; }
    friend Constructed operator/(const Constructed& a, const Constructed& b) { return a.value_ / b.value_; }
    friend bool operator<(const Constructed& a, const Constructed& b) { return a.value_ < b.value_; }

private:
    using Lazy = CGAL::Lazy_exact_nt<Rational>;

    Constructed(Lazy value) : value_(std::move(value)) {}

    Lazy value_;
};

/// The operations that OnRegions needs, in constructed numbers.
template <class Tally>
struct ConstructedNumbers : FilteredBy<Tally> {
    using Number = Constructed;

    ConstructedNumbers() = default;
    explicit ConstructedNumbers(FilteredBy<Tally> kernel) : FilteredBy<Tally>(std::move(kernel)) {}

    Constructed number(double given) const { return given; }

    /// Intermediate results are not constructed numbers.
    Sign sign_of(const auto& formula, const auto&... values) const {
        const auto [sign, by_interval] = enclosed_sign(formula, values...);
        tell(by_interval ? FilterStage::operands : FilterStage::exact);
        return sign;
    }
    Sign sign(const Constructed& value) const { return sign_of(itself, value); }

    int first_centre(const Constructed& value, int low, int end) const {
        return first_not([&](int pixel) { return sign(number(pixel + 0.5) - value) == Sign::negative; }, low, end);
    }
    int last_centre(const Constructed& value, int low, int end) const {
        return first_not([&](int pixel) { return sign(number(pixel + 0.5) - value) != Sign::positive; }, low, end) - 1;
    }

protected:
    static constexpr auto itself = [](const auto& value) { return value; };

private:
    using FilteredBy<Tally>::first_not;

    void tell(FilterStage stage) const { PlaneDepths<FilteredPlane, Tally>::tell(stage); }
};

template <class Tally>
struct OnRegions<FilteredBy<Tally>> : OnRegions<ConstructedNumbers<Tally>> {
    OnRegions() = default;
    explicit OnRegions(FilteredBy<Tally> kernel)
        : OnRegions<ConstructedNumbers<Tally>>(ConstructedNumbers<Tally>(std::move(kernel))) {}
};

}  // namespace vidno
