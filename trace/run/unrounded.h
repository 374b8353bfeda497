/// Operations on doubles that need no rounding, and the rounding errors of products.
///
/// An error of rounding is itself a double that can be computed: T. J. Dekker, "A Floating-Point Technique for
/// Extending the Available Precision", 1971.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace vidno::unrounded {

/// The error of a product below this may be too small for a double.
constexpr double least = 0x1p-900;

/// std::plus, minus, multiplies or divides of two doubles. None if the result was rounded, or may have been.
inline std::optional<double> result(std::plus<>, double a, double b) {
    const double sum = a + b;
    const double of_b = sum - a;
    const double error = (a - (sum - of_b)) + (b - of_b);
    return error == 0 ? std::optional(sum) : std::nullopt;  // an infinite sum has no error that is a number
}

inline std::optional<double> result(std::minus<>, double a, double b) { return result(std::plus<>(), a, -b); }

/// Two doubles of at most 26 bits each whose sum is the given one. NaN if it is nearly infinite.
inline std::pair<double, double> halves(double value) {
    const double scaled = value * (0x1p27 + 1);
    const double high = scaled - (scaled - value);
    return {high, value - high};
}

/// A product of doubles as the sum of the nearest double and its rounding error.
struct Product {
    double nearest, error;
};

/// None if the product is nearly infinite, or too small for its error to be a double. Not by std::fma, which is slow in
/// WebAssembly.
inline std::optional<Product> product(double a, double b) {
    if (a == 0 || b == 0) return Product{0, 0};
    const double nearest = a * b;
    const auto [a_high, a_low] = halves(a);
    const auto [b_high, b_low] = halves(b);
    const double error = a_low * b_low - (((nearest - a_high * b_high) - a_low * b_high) - a_high * b_low);
    return std::abs(nearest) >= least && std::isfinite(error) ? std::optional(Product{nearest, error}) : std::nullopt;
}

inline std::optional<double> result(std::multiplies<>, double a, double b) {
    const auto found = product(a, b);
    return found && found->error == 0 ? std::optional(found->nearest) : std::nullopt;
}

inline std::optional<double> result(std::divides<>, double a, double b) {
    if (b == 0) return std::nullopt;
    if (a == 0) return 0;
    const double quotient = a / b;
    return result(std::multiplies<>(), quotient, b) == a ? std::optional(quotient) : std::nullopt;
}

}  // namespace vidno::unrounded
