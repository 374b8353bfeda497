// Included before everything else. CGAL's intervals set the rounding mode to upward, where there is one. Here there is
// none, and each operation would step to the next number even if nothing was lost: 1 + 1 would be an interval, and
// appear as 2.0000000000000004. So we compute the loss; the bounds are then those of a machine with rounding modes, to
// the last bit.

#pragma once

#include <CGAL/FPU.h>

#include <cmath>
#include <limits>

namespace vidno::upward {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
// Below it the loss of a product or a quotient may be too small for a double.
inline constexpr double smallest_sure = 0x1p-960;

/// The exact result is `lost` more than the one rounded to nearest. Only a finite one can be too large for a number.
inline double raised(double rounded, double lost, bool finite) {
    if (std::isinf(rounded)) return rounded < 0 && finite ? std::numeric_limits<double>::lowest() : rounded;
    return lost > 0 ? std::nextafter(rounded, infinity) : rounded;
}

/// The rounding error of a sum, by Knuth's algorithm.
inline double sum(double a, double b) {
    const double rounded = a + b;
    const double of_b = rounded - a;
    return raised(rounded, (a - (rounded - of_b)) + (b - of_b), std::isfinite(a) && std::isfinite(b));
}

inline double product(double a, double b) {
    const double rounded = a * b;
    const bool sure = a == 0 || b == 0 || std::abs(rounded) >= smallest_sure;
    return raised(rounded, sure ? std::fma(a, b, -rounded) : 1, std::isfinite(a) && std::isfinite(b));
}

/// The remainder has the sign of the loss, or the opposite sign if b < 0.
inline double quotient(double a, double b) {
    const double rounded = a / b;
    const double remainder = std::fma(-rounded, b, a);
    const bool sure = a == 0 || (std::abs(a) >= smallest_sure && std::abs(rounded) >= smallest_sure);
    return raised(rounded, !sure ? 1 : b > 0 ? remainder : -remainder, std::isfinite(a) && b != 0);
}

}  // namespace vidno::upward

#undef CGAL_IA_ADD
#undef CGAL_IA_SUB
#undef CGAL_IA_MUL
#undef CGAL_IA_DIV
#define CGAL_IA_ADD(a, b) vidno::upward::sum(a, b)
#define CGAL_IA_SUB(a, b) vidno::upward::sum(a, -(b))
#define CGAL_IA_MUL(a, b) vidno::upward::product(a, b)
#define CGAL_IA_DIV(a, b) vidno::upward::quotient(a, b)
#define CGAL_IA_SQUARE(a) vidno::upward::product(a, a)
