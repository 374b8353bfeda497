/// ExactNumber: an exact number of a run, a quotient of doubles for as long as these hold it.
///
/// Most coordinates are doubles with few digits, and so are their sums and products; most depths are quotients of
/// these. For them an operation on doubles gives the exact result, and shows that it does. Otherwise the result is a
/// rational, which takes memory and a greatest common divisor.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>

#include "format/verdict.h"
#include "json/json_text.h"
#include "run/unrounded.h"
#include "vidno/kernels/exact.h"

namespace vidno {

/// A finite double as odd * 2^power; 0 as 0 * 2^0.
struct Dyadic {
    std::int64_t odd;
    int power;
};
inline Dyadic dyadic(double value) {
    if (value == 0) return {0, 0};
    constexpr int fraction_bits = std::numeric_limits<double>::digits - 1;
    constexpr std::uint64_t hidden_bit = std::uint64_t{1} << fraction_bits;
    const auto pattern = std::bit_cast<std::uint64_t>(value);
    const int exponent = int(pattern >> fraction_bits) & (2 * std::numeric_limits<double>::max_exponent - 1);
    const std::uint64_t significand = (pattern & (hidden_bit - 1)) + (exponent > 0 ? hidden_bit : 0);
    const int zeros = std::countr_zero(significand);
    const auto odd = std::int64_t(significand >> zeros);
    // The exponent of the least double, and of all that are as small, is stored as 0.
    constexpr int least = std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;
    return {value < 0 ? -odd : odd, least + std::max(exponent - 1, 0) + zeros};
}

/// value * 2^power; none if it is no word.
inline std::optional<std::int64_t> shifted(std::int64_t value, int power) {
    const auto magnitude = std::uint64_t(value < 0 ? -value : value);
    if (power > std::numeric_limits<std::int64_t>::digits - int(std::bit_width(magnitude))) return std::nullopt;
    return value * (std::int64_t{1} << power);
}

/// The quotient of two finite doubles, the second positive, as "p/q" in lowest terms.
inline std::string quotient_text(double over, double under) {
    // A judged run writes each number that it uses. Nearly all of them are quotients of two words, which need no
    // rationals.
    const auto [p, p_power] = dyadic(over);
    const auto [q, q_power] = dyadic(under);
    const std::int64_t divisor = q == 1 ? 1 : std::gcd(p, q);
    const int power = p == 0 ? 0 : p_power - q_power;
    const auto numerator = shifted(p / divisor, std::max(power, 0));
    const auto denominator = shifted(q / divisor, std::max(-power, 0));
    if (!numerator || !denominator) return Exact::fraction(Rational(over) / Rational(under));
    std::array<char, 2 * longest_number + 1> text;
    char* end = write_integer(text.data(), *numerator);
    *end++ = '/';
    end = write_integer(end, *denominator);
    return {text.data(), end};
}

/// A double as a fraction.
inline Fraction fraction_of(double value) {
    if (!std::isfinite(value)) return {std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf"};
    return {quotient_text(value, 1)};
}

class ExactNumber {
public:
    /// No number.
    ExactNumber() = default;
    /// The value must be finite. -0 becomes 0, since rationals have no other.
    explicit ExactNumber(double value) : ExactNumber(value, 1) {}
    explicit ExactNumber(Rational value) : shared_(std::make_shared<Shared>(std::move(value))) {}

    explicit operator bool() const { return shared_ || has_doubles(); }

    /// The number as a double; none if it is stored otherwise.
    std::optional<double> as_double() const {
        return has_doubles() && under_ == 1 ? std::optional(over_) : std::nullopt;
    }
    Rational rational() const {
        return as_rational([](const Rational& value) { return value; });
    }

    /// The nearest double or one next to it.
    explicit operator double() const {
        const auto value = as_double();
        return value ? *value : CGAL::to_double(rational());
    }
    Sign sign() const {
        return has_doubles() ? Sign{int(over_ > 0) - int(over_ < 0)} : Sign{int(CGAL::sign(shared_->value))};
    }
    /// The greatest whole number low <= i < end that is not above the number, which lies in that range.
    int whole_part(int low, int end) const {
        const auto is_above = [&](int whole) { return related(ExactNumber(whole), *this, std::greater<>()); };
        const auto about = double(*this);
        int whole = about > low ? int(std::min(about, end - 1.0)) : low;
        while (whole > low && is_above(whole)) --whole;
        while (whole + 1 < end && !is_above(whole + 1)) ++whole;
        return whole;
    }

    /// "p/q" in lowest terms, q > 0. The text of a rational is written once.
    std::string fraction() const {
        if (!shared_) return quotient_text(over_, under_);
        if (shared_->fraction.empty()) shared_->fraction = Exact::fraction(shared_->value);
        return shared_->fraction;
    }

    friend ExactNumber operator-(const ExactNumber& a) {
        return a.has_doubles() ? ExactNumber(-a.over_, a.under_) : ExactNumber(Rational(-a.shared_->value));
    }

    /// The result of std::plus, minus, multiplies or divides. A divisor must not be 0.
    static ExactNumber result(const ExactNumber& a, const ExactNumber& b, auto operation) {
        if (a.has_doubles() && b.has_doubles()) {
            if (ExactNumber found = of_doubles(a, b, operation)) return found;
            if (ExactNumber found = of_doubles(a.reduced(), b.reduced(), operation)) return found;
        }
        return as_rationals(a, b, [&](const auto& p, const auto& q) { return ExactNumber(Rational(operation(p, q))); });
    }
    /// Whether std::less, equal_to or another relation holds.
    static bool related(const ExactNumber& a, const ExactNumber& b, auto relation) {
        if (a.has_doubles() && b.has_doubles()) {
            if (a.under_ == b.under_) return relation(a.over_, b.over_);
            const auto left = unrounded::product(a.over_, b.under_), right = unrounded::product(b.over_, a.under_);
            if (left && right) {
                // Rounding keeps the order, so only products that round alike are left to their errors.
                return left->nearest != right->nearest ? relation(left->nearest, right->nearest)
                                                       : relation(left->error, right->error);
            }
        }
        return as_rationals(a, b, [&](const auto& p, const auto& q) -> bool { return relation(p, q); });
    }

private:
    using MaybeDouble = std::optional<double>;

    /// Most numbers are copied more often than computed with.
    struct Shared {
        explicit Shared(Rational given) : value(std::move(given)) {}
        Rational value;
        std::string fraction{};
    };

    ExactNumber(double over, double under) : over_(over + 0.0), under_(under) {}

    bool has_doubles() const { return !std::isnan(over_); }

    template <class Use>
    std::invoke_result_t<Use, const Rational&> as_rational(Use&& use) const {
        if (!shared_ && under_ == 1) return use(Rational(over_));
        // Kept, since the same number is often used again.
        if (!shared_) shared_ = std::make_shared<Shared>(Rational(over_) / Rational(under_));
        return use(shared_->value);
    }

    /// This number as a quotient of doubles with fewer digits.
    ExactNumber reduced() const {
        if (under_ == 1) return *this;
        const auto divisor = double(std::gcd(dyadic(over_).odd, dyadic(under_).odd));
        return {over_ / divisor, under_ / divisor};
    }

    static MaybeDouble product(double a, double b) { return unrounded::result(std::multiplies<>(), a, b); }

    static MaybeDouble whole_quotient(double a, double b) {
        const auto quotient = unrounded::result(std::divides<>(), a, b);
        return quotient && *quotient == std::floor(*quotient) ? quotient : std::nullopt;
    }

    /// The number over / under; none if one of them is none.
    static ExactNumber quotient(MaybeDouble over, MaybeDouble under) {
        if (!over || !under) return {};
        if (*under == 1) return ExactNumber(*over);
        if (const auto value = unrounded::result(std::divides<>(), *over, *under)) return ExactNumber(*value);
        return *under < 0 ? ExactNumber(-*over, -*under) : ExactNumber(*over, *under);
    }

    /// The result for quotients of doubles; none if doubles do not hold it.
    static ExactNumber of_doubles(const ExactNumber& a, const ExactNumber& b, std::multiplies<>) {
        return quotient(product(a.over_, b.over_), product(a.under_, b.under_));
    }
    static ExactNumber of_doubles(const ExactNumber& a, const ExactNumber& b, std::divides<>) {
        return quotient(product(a.over_, b.under_), product(a.under_, b.over_));
    }
    static ExactNumber of_doubles(const ExactNumber& a, const ExactNumber& b, auto plus_or_minus) {
        if (a.under_ == b.under_) return quotient(unrounded::result(plus_or_minus, a.over_, b.over_), a.under_);
        // A slope is added at each pixel of a row: the denominator must not grow with each of them.
        if (const auto times = whole_quotient(a.under_, b.under_)) {
            const auto over = product(b.over_, *times);
            return over ? quotient(unrounded::result(plus_or_minus, a.over_, *over), a.under_) : ExactNumber();
        }
        const auto left = product(a.over_, b.under_), right = product(b.over_, a.under_);
        if (!left || !right) return {};
        return quotient(unrounded::result(plus_or_minus, *left, *right), product(a.under_, b.under_));
    }

    static auto as_rationals(const ExactNumber& a, const ExactNumber& b, auto&& use) {
        return a.as_rational(
            [&](const Rational& p) { return b.as_rational([&](const Rational& q) { return use(p, q); }); });
    }

    // The number is over / under, unless it has no doubles. The denominator is positive.
    double over_ = std::numeric_limits<double>::quiet_NaN();
    double under_ = 1;
    mutable std::shared_ptr<Shared> shared_;  // the number as a rational, once it is needed
};

}  // namespace vidno
