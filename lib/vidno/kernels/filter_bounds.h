/// FilterBounds: what a double decides for the kernel `filtered`, since the bound on its error allows it.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "bounded.h"
#include "number_kernel.h"

namespace vidno {

struct FilterBounds {
    /// A bound that is NaN bounds nothing.
    static double at_most(double error) { return std::isnan(error) ? infinity : error; }

    static Sign sign_of(double value) { return Sign{int(value > 0) - int(value < 0)}; }

    static std::optional<Sign> certain_sign(const Bounded& v) {
        if (sign_is_certain(v)) return sign_of(v.value);
        if (v.value == 0 && v.error == 0) return Sign::zero;
        return std::nullopt;
    }

    /// The least or the greatest of some values: the double to show, and the bounds between which the exact one lies.
    class Range {
    public:
        double value = 0;

        void least(const Bounded& v) {
            include(v, [](double a, double b) { return b < a ? b : a; });
        }
        void greatest(const Bounded& v) {
            include(v, [](double a, double b) { return a < b ? b : a; });
        }
        bool empty() const { return !any_; }
        double low() const { return known_ ? low_ : -infinity; }
        double high() const { return known_ ? high_ : infinity; }

    private:
        void include(const Bounded& v, auto&& choose) {
            known_ = known_ && std::isfinite(v.low()) && std::isfinite(v.high());
            value = any_ ? choose(value, v.value) : v.value;
            low_ = any_ ? choose(low_, v.low()) : v.low();
            high_ = any_ ? choose(high_, v.high()) : v.high();
            any_ = true;
        }

        double low_ = 0, high_ = 0;
        bool any_ = false, known_ = true;
    };

    struct Interval {
        double low, high;
    };
    static Interval interval_of(const Bounded& v) {
        const bool known = std::isfinite(v.low()) && std::isfinite(v.high());
        return known ? Interval{v.low(), v.high()} : Interval{-infinity, infinity};
    }

    /// The first pixel whose centre is after the value, if the value is certainly at no centre; the last one before it
    /// is the pixel to the left. Values off the area move to half a pixel from its outer centres. In the area,
    /// distances are less than 2^15, so that roundoff is hardly more than half of 2^-38. A value that is not finite has
    /// no finite error.
    static std::optional<int> first_after(const Bounded& v, int low, int end) {
        const double distance = std::min(std::max(0.5, v.value - (low - 0.5)), end - low + 0.5);
        const int whole = int(distance);
        const bool apart = std::abs(distance - whole - 0.5) + v.error < 0.5 - 0x1p-38;
        return apart ? std::optional(low + whole) : std::nullopt;
    }
    /// Certain if the centres on either side of the value lie outside its bounds; never if the bounds are unknown.
    static std::optional<int> certain_first(const auto& v, int low, int end) {
        const int first = machine_.first_centre(v.value, low, end);
        const bool certain = (first == low || first - 0.5 < v.low()) && (first == end || v.high() <= first + 0.5);
        return certain ? std::optional(first) : std::nullopt;
    }
    static std::optional<int> certain_last(const auto& v, int low, int end) {
        const int last = machine_.last_centre(v.value, low, end);
        const bool certain = (last == low - 1 || last + 0.5 <= v.low()) && (last == end - 1 || v.high() < last + 1.5);
        return certain ? std::optional(last) : std::nullopt;
    }

    static Bounded exact_one(const Bounded& a, const Bounded& b) { return a.is_exact() ? a : b; }

    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr NumberKernel<double> machine_{};
};

}  // namespace vidno
