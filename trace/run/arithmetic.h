/// Arithmetic: how the numbers of a run are rounded, as chosen at run time.
#pragma once

#include <limits>
#include <stdexcept>

#include "choice/kernel_choice.h"

namespace vidno {

/// How results are rounded. A constant has no arithmetic of its own: it takes that of the other operand.
struct Arithmetic {
    enum class Kind : unsigned char { constant, binary32, binary64, bits, exact };

    Kind kind = Kind::constant;
    int bits = 0;  // of Kind::bits

    /// Throws std::invalid_argument for `filtered` and `grid`: they compare planes and whole numbers.
    static Arithmetic of(const NamedKernel& kernel) {
        switch (kernel.kind()) {
            case KernelKind::binary32: return {Kind::binary32};
            case KernelKind::binary64:
            case KernelKind::depth: return {Kind::binary64};
            case KernelKind::bits: return {Kind::bits, kernel.parameter};
            case KernelKind::exact: return {Kind::exact};
            default: throw std::invalid_argument(kernel.name() + " is no kernel of numbers");
        }
    }

    bool is_of_constants() const { return kind == Kind::constant; }
    bool is_exact() const { return kind == Kind::exact; }

    /// The number of significant bits of its numbers; for exact ones, that of a double.
    int digits() const {
        if (kind == Kind::bits) return bits;
        return kind == Kind::binary32 ? std::numeric_limits<float>::digits : std::numeric_limits<double>::digits;
    }

    double rounded(double given) const {
        switch (kind) {
            case Kind::binary32: return double(float(given));
            case Kind::bits: return rounded_to(bits, given);
            default: return given;
        }
    }
    /// The result of + - * or / on two of its numbers. Rounding twice, to a double first, is rounding once: see bits.h.
    double result(double a, double b, auto operation) const { return rounded(operation(a, b)); }
};

}  // namespace vidno
