/// Exact rationals: every decision is right for the doubles of the scene. The reference for all other kernels.
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Interval_nt.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "../weiler_atherton/weiler_atherton_kernel.h"
#include "number_kernel.h"

namespace vidno {

using Rational = CGAL::Exact_rational;

struct Exact : NumberKernel<Rational> {
    static constexpr std::string_view name = "exact";

    bool same_rounded(const Rational& v, const Rational& w) const {
        const Rational half(0.5);
        return floor(Rational(v + half)) == floor(Rational(w + half));
    }

    /// "p/q" in lowest terms, q > 0.
    static std::string fraction(const Rational& value) { return fraction_text(value); }

private:
    using Fractions = CGAL::Fraction_traits<Rational>;
    using Integer = Fractions::Numerator_type;

    /// Numerator and denominator, the latter positive.
    static std::pair<Integer, Integer> parts(const Rational& value) {
        Integer p, q;
        Fractions::Decompose()(value, p, q);
        if (q < 0) {
            p = -p;
            q = -q;
        }
        return {p, q};
    }

    /// A template, because the type of Rational depends on how CGAL was built.
    static std::string fraction_text(const auto& value) {
        if constexpr (requires { value.get_str(); }) {
            // GMP keeps a rational in lowest terms. A stream would take ten times as long.
            std::string text = value.get_str();
            if (text.find('/') == std::string::npos) text += "/1";
            return text;
        } else {
            const auto [p, q] = parts(value);
            if (is_word(p) && is_word(q)) {
                const auto p_word = static_cast<std::int64_t>(p), q_word = static_cast<std::int64_t>(q);
                const std::int64_t divisor = std::gcd(p_word, q_word);
                return std::to_string(p_word / divisor) + '/' + std::to_string(q_word / divisor);
            }
            const Integer divisor = CGAL::gcd(p, q);
            return digits(Integer(p / divisor)) + '/' + digits(Integer(q / divisor));
        }
    }

    /// Whether the integer and its negative are 64-bit integers.
    static bool is_word(const auto& integer) {
        constexpr auto greatest = std::numeric_limits<std::int64_t>::max();
        return -greatest <= integer && integer <= greatest;
    }

    static std::string digits(const auto& number) {
        if constexpr (requires { number.str(); }) {
            return number.str();
        } else {
            std::ostringstream text;
            text << number;
            return text.str();
        }
    }

    static Integer floor(const Rational& value) {
        const auto [p, q] = parts(value);
        const Integer quotient = p / q;  // towards zero
        return Integer(quotient * q) > p ? Integer(quotient - 1) : quotient;
    }
};

using Interval = CGAL::Interval_nt<false>;

/// The double nearest to the value; ties go to even.
inline double nearest_double(const Rational& value) {
    double nearest = CGAL::to_double(value);  // or a few doubles away
    while (std::isfinite(nearest)) {
        // Comparing with fractions of powers of two is cheap. The difference of two rationals would have to be reduced.
        const auto side = CGAL::compare(value, Rational(nearest));
        const double next = std::nextafter(nearest, side == CGAL::SMALLER ? -HUGE_VAL : HUGE_VAL);
        if (side == CGAL::EQUAL || !std::isfinite(next)) break;
        const auto side_of_middle = CGAL::compare(value, Rational((Rational(nearest) + Rational(next)) / 2));
        const bool is_even = std::bit_cast<std::uint64_t>(nearest) % 2 == 0;
        if (side_of_middle == CGAL::EQUAL ? is_even : side_of_middle != side) break;
        nearest = next;
    }
    return nearest;
}

struct EnclosedSign {
    Sign sign;
    bool by_interval;  // otherwise by rational numbers
};

/// The sign of a formula over numbers that each have an `interval()` and an exact value, `exactly()`. If the formula's
/// interval has a sign, no rational number is computed.
EnclosedSign enclosed_sign(const auto& formula, const auto&... values) {
    const auto by_interval = [&] {
        const CGAL::Protect_FPU_rounding<true> upward;
        return CGAL::sign(formula(values.interval()...));
    }();
    if (by_interval.is_certain()) return {Sign{int(by_interval.make_certain())}, true};
    return {Sign{int(CGAL::sign(formula(values.exactly()...)))}, false};
}

EnclosedSign enclosed_sign(NumberDifference, const auto& v, const auto& w) {
    const auto by_interval = CGAL::compare(v.interval(), w.interval());
    if (by_interval.is_certain()) return {Sign{int(by_interval.make_certain())}, true};
    return {Sign{int(CGAL::compare(v.exactly(), w.exactly()))}, false};
}

/// A rational number and an interval that holds it. Copies share the rational, since the vertices of regions are copied
/// more often than computed.
class Enclosed {
public:
    Enclosed(double given = 0) : value_(std::make_shared<const Rational>(given)), interval_(given) {}
    Enclosed(Rational value)
        : value_(std::make_shared<const Rational>(std::move(value))), interval_(CGAL::to_interval(*value_)) {}

    const Rational& exactly() const { return *value_; }
    operator const Rational&() const { return *value_; }
    const Interval& interval() const { return interval_; }
    explicit operator double() const { return nearest_double(*value_); }

    Enclosed& operator+=(const Enclosed& other) { return *this = *this + other; }

    friend Enclosed operator-(const Enclosed& a) { return Rational(-*a.value_); }
    friend Enclosed operator+(const Enclosed& a, const Enclosed& b) { return Rational(*a.value_ + *b.value_); }
    friend Enclosed operator-(const Enclosed& a, const Enclosed& b) { return Rational(*a.value_ - *b.value_); }
    friend Enclosed operator*(const Enclosed& a, const Enclosed& b) { return Rational(*a.value_ * *b.value_); }
    friend Enclosed operator/(const Enclosed& a, const Enclosed& b) { return Rational(*a.value_ / *b.value_); }
    friend bool operator<(const Enclosed& a, const Enclosed& b) {
        const auto by_intervals = a.interval_ < b.interval_;
        return by_intervals.is_certain() ? by_intervals.make_certain() : *a.value_ < *b.value_;
    }
    friend bool operator>(const Enclosed& a, const Enclosed& b) { return b < a; }
    friend bool operator<=(const Enclosed& a, const Enclosed& b) { return !(b < a); }
    friend bool operator>=(const Enclosed& a, const Enclosed& b) { return !(a < b); }

private:
    std::shared_ptr<const Rational> value_;
    Interval interval_;
};

/// The operations that OnRegions needs. Each number is computed exactly. The sign of a formula is that of its interval
/// where this has one, since Weiler and Atherton's algorithm needs many signs of few points.
struct EnclosedNumbers : NumberKernel<Enclosed> {
    Sign sign_of(const auto& formula, const auto&... values) const { return enclosed_sign(formula, values...).sign; }
};

template <>
struct OnRegions<Exact> : OnRegions<EnclosedNumbers> {
    OnRegions() = default;
    explicit OnRegions(const Exact&) {}
};

}  // namespace vidno
