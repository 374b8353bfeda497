/// The kernel `filtered` for Weiler and Atherton's algorithm: a constructed number is an interval and remembers its operands.
///
/// The interval decides a sign where it can; else the number is computed exactly. Nothing that was rounded decides.
#pragma once

#include <CGAL/Lazy_exact_nt.h>

#include <utility>

#include "../weiler_atherton/weiler_atherton_kernel.h"
#include "filtered.h"

namespace vidno {

class Constructed {
public:
    Constructed(double given = 0) : value_(given) {}

    /// Near enough to be shown; it asks for nothing exact.
    explicit operator double() const { return CGAL::to_double(value_.approx()); }

    Rational exactly() const { return value_.exact(); }

    /// If the interval says it.
    CGAL::Uncertain<CGAL::Sign> sign_by_interval() const { return CGAL::sign(value_.approx()); }
    CGAL::Sign exact_sign() const { return CGAL::sign(value_.exact()); }

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

/// What OnRegions asks a kernel for, in constructed numbers.
template <class Tally>
struct ConstructedNumbers : FilteredBy<Tally> {
    using Number = Constructed;

    ConstructedNumbers() = default;
    explicit ConstructedNumbers(FilteredBy<Tally> kernel) : FilteredBy<Tally>(std::move(kernel)) {}

    Constructed number(double given) const { return given; }

    Sign sign(const Constructed& value) const {
        const auto certain = value.sign_by_interval();
        tell(certain.is_certain() ? FilterStage::operands : FilterStage::exact);
        return Sign{int(certain.is_certain() ? certain.make_certain() : value.exact_sign())};
    }

    int first_centre(const Constructed& value, int low, int end) const {
        return first_not([&](int pixel) { return sign(number(pixel + 0.5) - value) == Sign::negative; }, low, end);
    }
    int last_centre(const Constructed& value, int low, int end) const {
        return first_not([&](int pixel) { return sign(number(pixel + 0.5) - value) != Sign::positive; }, low, end) - 1;
    }

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
