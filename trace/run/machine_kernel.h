/// MachineKernel: float, double, bits and depth as one kernel, for recorded runs that nobody judges. It is compiled
/// once for all of them.
///
/// Its numbers are mere values, which a page computes with while a corner is dragged. The thread has their arithmetic:
/// numbers that carry it take up to 1.2 times as long. So a thread has one such kernel at a time.
#pragma once

#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>

#include "run/arithmetic.h"
#include "vidno/kernels/machine.h"

namespace vidno {

/// A number of this thread's arithmetic, or a constant: a result of constants is a constant, and is not rounded.
class MachineNumber {
public:
    static inline thread_local Arithmetic arithmetic;

    MachineNumber() = default;
    MachineNumber(std::integral auto constant) : value_(double(constant)) {}
    MachineNumber(double constant) : value_(constant) {}

    static bool is_binary32() { return arithmetic.kind == Arithmetic::Kind::binary32; }
    static MachineNumber rounded(double given) { return {arithmetic.rounded(given), false}; }
    /// A result in binary32.
    static MachineNumber of(float result) { return {double(result), false}; }

    explicit operator double() const { return value_; }
    explicit operator float() const { return float(value_); }

    MachineNumber& operator+=(const MachineNumber& other) { return *this = *this + other; }

    friend MachineNumber operator-(MachineNumber a) {
        a.value_ = -a.value_;
        return a;
    }
    friend MachineNumber operator+(const MachineNumber& a, const MachineNumber& b) {
        return computed(a, b, std::plus<>());
    }
    friend MachineNumber operator-(const MachineNumber& a, const MachineNumber& b) {
        return computed(a, b, std::minus<>());
    }
    friend MachineNumber operator*(const MachineNumber& a, const MachineNumber& b) {
        return computed(a, b, std::multiplies<>());
    }
    friend MachineNumber operator/(const MachineNumber& a, const MachineNumber& b) {
        return computed(a, b, std::divides<>());
    }

    friend MachineNumber floor(MachineNumber a) {
        a.value_ = std::floor(a.value_);
        return a;
    }

    friend bool operator==(const MachineNumber& a, const MachineNumber& b) { return a.value_ == b.value_; }
    friend auto operator<=>(const MachineNumber& a, const MachineNumber& b) { return a.value_ <=> b.value_; }

private:
    MachineNumber(double value, bool is_constant) : value_(value), is_constant_(is_constant) {}

    static MachineNumber computed(const MachineNumber& a, const MachineNumber& b, auto operation) {
        const double result = operation(a.value_, b.value_);
        // The most common arithmetic first. Results of constants are exact in it.
        if (is_binary32()) return of(float(result));
        if (a.is_constant_ && b.is_constant_) return result;
        return {arithmetic.rounded(result), false};
    }

    double value_ = 0;
    bool is_constant_ = true;
};

/// How a coordinate becomes a number.
struct MachineEntry {
    MachineNumber number(double given) const { return MachineNumber::rounded(given); }
};

}  // namespace vidno

template <>
struct std::numeric_limits<vidno::MachineNumber> {
    static constexpr bool is_specialized = true;
    static constexpr bool has_infinity = true;
    static vidno::MachineNumber infinity() { return std::numeric_limits<double>::infinity(); }
};

namespace vidno {

struct MachineKernel : NumberKernel<MachineNumber, MachineEntry> {
    static constexpr std::string_view name = "machine";

    /// The kernel must be one of numbers that are not exact.
    explicit MachineKernel(const NamedKernel& kernel) {
        MachineNumber::arithmetic = Arithmetic::of(kernel);
        if (kernel.kind() == KernelKind::depth) depth_bits_ = DepthBits(kernel.parameter);
    }

    // A page computes these two most often, and most often in binary32, where the arithmetic is chosen once for the
    // whole formula.

    Number cross(const auto& pivot, const auto& a, const auto& b) const {
        if (!MachineNumber::is_binary32()) return NumberKernel::cross(pivot, a, b);
        return MachineNumber::of(Float().cross(in_floats(pivot), in_floats(a), in_floats(b)));
    }
    Depth depth(const Plane& plane, const auto& point) const {
        if (!MachineNumber::is_binary32()) return NumberKernel::depth(plane, point);
        const Float::Plane rounded{float(plane.a), float(plane.b), float(plane.c), float(plane.d)};
        return MachineNumber::of(Float().depth(rounded, in_floats(point)));
    }

    Number to_store(const Number& z) const { return depth_bits_ ? number(depth_bits_->to_store(double(z))) : z; }

private:
    static Point<float> in_floats(const auto& point) { return {float(point.x), float(point.y)}; }

    std::optional<DepthBits> depth_bits_;
};

}  // namespace vidno
