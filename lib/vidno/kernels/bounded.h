/// Given and Bounded: doubles with a bound on their error.
///
/// A coordinate of the scene is Given: exact. A value computed from coordinates is Bounded: a double, and a bound on
/// its distance from the exact result of the same formula. Each operation increases the bound by the rounding error it
/// may add.
#pragma once

#include <cmath>
#include <compare>
#include <limits>

namespace vidno {

/// A double that is exact: it compares as it stands.
struct Given {
    double value = 0;

    explicit operator double() const { return value; }
    auto operator<=>(const Given&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 takes it for a 0
};

/// |value - exact| <= error. An error of 0 means that the value is exact. An infinite error, or a value that is not
/// finite, means that nothing is known.
struct Bounded {
    double value = 0, error = 0;

    Bounded() = default;
    Bounded(double exact) : value(exact) {}
    Bounded(Given exact) : value(exact.value) {}
    Bounded(double approximate, double at_most) : value(approximate), error(at_most) {}

    explicit operator double() const { return value; }
    bool is_exact() const { return error == 0; }
    double low() const { return is_exact() ? value : value - outward(); }
    double high() const { return is_exact() ? value : value + outward(); }

    /// Twice the unit roundoff of binary64: the other half pays for the rounding of the bounds themselves.
    static constexpr double unit = std::numeric_limits<double>::epsilon();
    /// More than products and quotients lose by underflow.
    static constexpr double underflow = 0x1p-1000;

    Bounded& operator+=(const Bounded& other) {
        value += other.value;
        error += other.error + unit * std::abs(value);
        return *this;
    }

private:
    /// A little more than the error, so that the rounded sum with the value still bounds the exact one.
    double outward() const { return error * (1 + unit) + unit * std::abs(value); }
};

inline Bounded operator-(const Bounded& a) { return {-a.value, a.error}; }

inline Bounded operator+(Bounded a, const Bounded& b) { return a += b; }

inline Bounded operator-(Bounded a, const Bounded& b) { return a += -b; }

inline Bounded operator*(const Bounded& a, const Bounded& b) {
    const double value = a.value * b.value;
    return {value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error +
                       Bounded::unit * std::abs(value) + Bounded::underflow};
}

/// Unknown where the divisor may be 0.
inline Bounded operator/(const Bounded& a, const Bounded& b) {
    const double value = a.value / b.value;
    const double least_divisor = std::abs(b.value) - b.error * (1 + Bounded::unit);
    if (!(least_divisor > 0)) return {value, std::numeric_limits<double>::infinity()};
    return {value,
            (a.error + std::abs(value) * b.error + Bounded::underflow) / least_divisor * (1 + 4 * Bounded::unit) +
                Bounded::unit * std::abs(value) + Bounded::underflow};
}

/// Whether the bounds exclude 0, so that the value has the sign of the exact one.
inline bool sign_is_certain(const Bounded& a) {
    return std::abs(a.value) > a.error * (1 + Bounded::unit) && std::isfinite(a.value);
}

}  // namespace vidno
