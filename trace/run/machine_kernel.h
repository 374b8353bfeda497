/// MachineKernel: float, double, bits and depth as one kernel, for recorded runs that nobody judges. It is compiled once for all of them.
///
/// Its numbers are values, which a page computes with while a corner is dragged. Those of RunTimeKernel carry the truth as well.
#pragma once

#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>

#include "run/arithmetic.h"

namespace vidno {

/// A number that knows how results are rounded. A constant takes the arithmetic of the other operand.
class MachineNumber {
public:
    MachineNumber() = default;
    MachineNumber(std::integral auto constant) : value_(double(constant)) {}
    MachineNumber(double constant) : value_(constant) {}
    MachineNumber(const Arithmetic& arithmetic, double given)
        : value_(arithmetic.rounded(given)), arithmetic_(arithmetic) {}

    explicit operator double() const { return value_; }

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
    static MachineNumber computed(const MachineNumber& a, const MachineNumber& b, auto operation) {
        const Arithmetic& arithmetic = a.arithmetic_.is_of_constants() ? b.arithmetic_ : a.arithmetic_;
        MachineNumber result;
        result.value_ = arithmetic.result(a.value_, b.value_, operation);
        result.arithmetic_ = arithmetic;
        return result;
    }

    double value_ = 0;
    Arithmetic arithmetic_;
};

/// How a coordinate becomes a number.
struct MachineEntry {
    Arithmetic arithmetic;

    MachineNumber number(double given) const { return {arithmetic, given}; }
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
    explicit MachineKernel(const NamedKernel& kernel) : NumberKernel(MachineEntry{Arithmetic::of(kernel)}) {
        if (kernel.kind() == KernelKind::depth) depth_bits_ = DepthBits(kernel.parameter);
    }

    Number to_store(const Number& z) const { return depth_bits_ ? number(depth_bits_->to_store(double(z))) : z; }

private:
    std::optional<DepthBits> depth_bits_;
};

}  // namespace vidno
