/// Bits: every result rounded to P bits; decisions follow from the rounded values. Lowering P shows how accuracy is
/// lost.
///
/// Rounding is to nearest, ties to even. The exponent is a double's, so that only the precision decreases.
///
/// Source  For + - * / and P <= 25, rounding a double to P bits equals rounding the exact result once: S. A. Figueroa,
///         When is double rounding innocuous?, SIGNUM Newsletter 30(3), 1995.
#pragma once

#include <bit>
#include <cassert>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>

#include "number_kernel.h"

namespace vidno {

inline constexpr int fewest_bits = 4;
inline constexpr int most_bits = 24;

/// The lowest bit of a double's significand that a number with this many significant bits keeps.
inline std::uint64_t lowest_kept_bit(int bits) {
    return std::uint64_t{1} << (std::numeric_limits<double>::digits - bits);
}

/// The nearest double whose significand has no bits below the lowest kept one; ties go to even.
inline double rounded_at(std::uint64_t lowest, double value) {
    const auto pattern = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t tie_to_even = (pattern & lowest) != 0 ? lowest / 2 : lowest / 2 - 1;
    // A carry out of the significand belongs in the exponent.
    return std::isfinite(value) ? std::bit_cast<double>((pattern + tie_to_even) & -lowest) : value;
}

/// The nearest double with this number of significant bits; ties go to even.
inline double rounded_to(int bits, double value) { return rounded_at(lowest_kept_bit(bits), value); }

/// A double with a precision in bits. It carries the precision, since there is no global to hold it; a constant has
/// none.
class Rounded {
public:
    Rounded(double constant = 0) : value_(constant) {}
    Rounded(int bits, double value) : Rounded(lowest_kept_bit(bits), value) {}

    explicit operator double() const { return value_; }

    Rounded& operator+=(const Rounded& other) { return *this = *this + other; }

    friend Rounded operator-(const Rounded& a) { return result(a, a, -a.value_); }
    friend Rounded operator+(const Rounded& a, const Rounded& b) { return result(a, b, a.value_ + b.value_); }
    friend Rounded operator-(const Rounded& a, const Rounded& b) { return result(a, b, a.value_ - b.value_); }
    friend Rounded operator*(const Rounded& a, const Rounded& b) { return result(a, b, a.value_ * b.value_); }
    friend Rounded operator/(const Rounded& a, const Rounded& b) { return result(a, b, a.value_ / b.value_); }

    friend Rounded floor(const Rounded& a) { return result(a, a, std::floor(a.value_)); }

    friend bool operator==(const Rounded& a, const Rounded& b) { return a.value_ == b.value_; }
    friend auto operator<=>(const Rounded& a, const Rounded& b) { return a.value_ <=> b.value_; }

private:
    Rounded(std::uint64_t lowest, double value) : value_(rounded_at(lowest, value)), lowest_(lowest) {}

    static Rounded result(const Rounded& a, const Rounded& b, double value) {
        const std::uint64_t lowest = a.lowest_ | b.lowest_;
        return lowest != 0 ? Rounded(lowest, value) : Rounded(value);
    }

    double value_;
    std::uint64_t lowest_ = 0;  // the lowest bit kept
};

}  // namespace vidno

template <>
struct std::numeric_limits<vidno::Rounded> {
    static constexpr bool is_specialized = true;
    static constexpr bool has_infinity = true;
    static vidno::Rounded infinity() { return std::numeric_limits<double>::infinity(); }
};

namespace vidno {

struct ToBits {
    int bits;

    Rounded number(double given) const { return {bits, given}; }
};

struct Bits : NumberKernel<Rounded, ToBits> {
    static constexpr std::string_view name = "bits";

    /// fewest_bits <= count <= most_bits
    explicit Bits(int count) : NumberKernel(ToBits{count}) { assert(fewest_bits <= count && count <= most_bits); }
};

}  // namespace vidno
