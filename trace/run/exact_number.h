/// ExactNumber: an exact number of a run, a double for as long as one holds it.
///
/// Most numbers of most scenes are doubles with few digits, and so are their sums and products. For them an operation on doubles gives
/// the exact result, and shows that it does. Otherwise the result is a rational, which takes memory and a greatest common divisor.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "format/verdict.h"
#include "vidno/kernels/exact.h"

namespace vidno {

/// A double as a fraction.
inline Fraction fraction_of(double value) {
    if (!std::isfinite(value)) return {std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf"};
    constexpr int digits = std::numeric_limits<double>::digits;
    int exponent = 0;
    const auto significand = std::int64_t(std::ldexp(std::frexp(value, &exponent), digits));
    if (significand == 0) return {"0/1"};
    const int zeros = std::countr_zero(std::uint64_t(significand));
    const std::int64_t odd = significand >> zeros;
    const int power = exponent - digits + zeros;  // the value is odd * 2^power
    // A judged run writes each number that it uses. Nearly all of them are quotients of two words, which need no rationals.
    constexpr int most = std::numeric_limits<std::int64_t>::digits;
    if (exponent > most || power <= -most) return {Exact::fraction(Rational(value))};
    const std::int64_t numerator = odd * (std::int64_t{1} << std::max(power, 0));
    const std::int64_t denominator = std::int64_t{1} << std::max(-power, 0);
    return {std::to_string(numerator) + '/' + std::to_string(denominator)};
}

/// The result of an operation on doubles if no rounding was needed; none if it was, or if the doubles cannot tell.
///
/// An error of rounding is itself a double that can be computed: T. J. Dekker, "A Floating-Point Technique for Extending the Available
/// Precision", 1971. Below `least` it may be too small for a double.
namespace unrounded {

constexpr double least = 0x1p-900;

inline std::optional<double> result(std::plus<>, double a, double b) {
    const double sum = a + b;
    const double of_b = sum - a;
    const double error = (a - (sum - of_b)) + (b - of_b);
    return error == 0 ? std::optional(sum) : std::nullopt;  // an infinite sum has no error that is a number
}

inline std::optional<double> result(std::minus<>, double a, double b) { return result(std::plus<>(), a, -b); }

inline std::optional<double> result(std::multiplies<>, double a, double b) {
    if (a == 0 || b == 0) return 0;
    const double product = a * b;
    const bool is_exact = std::abs(product) >= least && std::fma(a, b, -product) == 0;
    return is_exact ? std::optional(product) : std::nullopt;
}

inline std::optional<double> result(std::divides<>, double a, double b) {
    if (b == 0) return std::nullopt;
    if (a == 0) return 0;
    const double quotient = a / b;
    const bool is_exact = std::abs(quotient) >= least && std::abs(a) >= least && std::fma(quotient, b, -a) == 0;
    return is_exact ? std::optional(quotient) : std::nullopt;
}

}  // namespace unrounded

class ExactNumber {
public:
    /// No number.
    ExactNumber() = default;
    /// The value must be finite. -0 becomes 0, since rationals have no other.
    explicit ExactNumber(double value) : double_(value + 0.0) {}
    explicit ExactNumber(Rational value) : shared_(std::make_shared<Shared>(std::move(value))) {}

    explicit operator bool() const { return shared_ || !std::isnan(double_); }

    /// The number as a double if one holds it and this is known.
    std::optional<double> as_double() const { return shared_ ? std::nullopt : std::optional(double_); }
    Rational rational() const { return shared_ ? shared_->value : Rational(double_); }

    /// The nearest double or one next to it.
    explicit operator double() const { return shared_ ? CGAL::to_double(shared_->value) : double_; }
    Sign sign() const {
        return shared_ ? Sign{int(CGAL::sign(shared_->value))} : Sign{int(double_ > 0) - int(double_ < 0)};
    }
    int whole_part(int low, int end) const {
        return shared_ ? vidno::whole_part(shared_->value, low, end) : vidno::whole_part(double_, low, end);
    }

    /// "p/q" in lowest terms, q > 0. The text of a rational is written once.
    std::string fraction() const {
        if (!shared_) return fraction_of(double_).text;
        if (shared_->fraction.empty()) shared_->fraction = Exact::fraction(shared_->value);
        return shared_->fraction;
    }

    friend ExactNumber operator-(const ExactNumber& a) {
        return a.shared_ ? ExactNumber(Rational(-a.shared_->value)) : ExactNumber(-a.double_);
    }

    /// The result of std::plus, minus, multiplies or divides. A divisor must not be 0.
    static ExactNumber result(const ExactNumber& a, const ExactNumber& b, auto operation) {
        if (!a.shared_ && !b.shared_) {
            if (const auto exact = unrounded::result(operation, a.double_, b.double_)) return ExactNumber(*exact);
        }
        return as_rationals(a, b, [&](const auto& p, const auto& q) { return ExactNumber(Rational(operation(p, q))); });
    }
    /// Whether std::less, equal_to or another relation holds.
    static bool related(const ExactNumber& a, const ExactNumber& b, auto relation) {
        if (!a.shared_ && !b.shared_) return relation(a.double_, b.double_);
        return as_rationals(a, b, [&](const auto& p, const auto& q) -> bool { return relation(p, q); });
    }

private:
    /// Most numbers are copied more often than computed with.
    struct Shared {
        explicit Shared(Rational given) : value(std::move(given)) {}
        Rational value;
        std::string fraction{};
    };

    auto as_rational(auto&& use) const { return shared_ ? use(shared_->value) : use(Rational(double_)); }
    static auto as_rationals(const ExactNumber& a, const ExactNumber& b, auto&& use) {
        return a.as_rational(
            [&](const Rational& p) { return b.as_rational([&](const Rational& q) { return use(p, q); }); });
    }

    double double_ = std::numeric_limits<double>::quiet_NaN();  // the number, if it is not shared
    std::shared_ptr<Shared> shared_;
};

}  // namespace vidno
