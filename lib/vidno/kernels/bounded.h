/// Given and Bounded: doubles with a bound on their error.
///
/// A coordinate of the scene is Given: exact. A value computed from coordinates is Bounded: a double, and a bound on
/// its distance from the exact result of the same formula. Each operation increases the bound by twice the rounding
/// error that it may add. So the distance is half of the bound, or a little more, since the bounds are rounded, too:
/// after fewer than 2^43 operations in a row it is at most 0.51 of the bound. tests/bounds has the proof.
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

    /// Twice the unit roundoff of binary64. Its rounded product with a normal value is at least the value's ulp; a
    /// subnormal sum is exact.
    static constexpr double unit = std::numeric_limits<double>::epsilon();
    /// More than products and quotients lose by underflow. It stays a normal number when it is divided by the distance
    /// of any two pixels that areas may have: processors are slow at subnormal ones.
    static constexpr double underflow = 0x1p-990;

    Bounded& operator+=(const Bounded& other) {
        value += other.value;
        error += other.error + unit * std::abs(value);
        return *this;
    }

private:
    /// More than the error, so that the rounded sum with the value still bounds the exact one.
    double outward() const { return error + unit * std::abs(value); }
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
    const double least_divisor = std::abs(b.value) - b.error;
    if (!(least_divisor > 0)) return {value, std::numeric_limits<double>::infinity()};
    return {value, (a.error + std::abs(value) * b.error + Bounded::underflow) / least_divisor +
                       Bounded::unit * std::abs(value) + Bounded::underflow};
}

/// Whether the bounds exclude 0, so that the value has the sign of the exact one.
inline bool sign_is_certain(const Bounded& a) { return std::abs(a.value) > a.error && std::isfinite(a.value); }

}  // namespace vidno
