/// Shadowed: a number in use, and beside it the truth: the same expression in exact rationals, along the path that was taken.
#pragma once

#include <concepts>
#include <functional>
#include <optional>

#include "verdict.h"
#include "vidno/kernels/exact.h"

namespace vidno {

template <class T>
struct Shadowed {
    T value{};
    std::optional<Rational> exact = Rational(0);  // none: undefined, as after a division by zero
    const Judge* judge = nullptr;                 // of the run that the number belongs to; none for a constant

    Shadowed() = default;
    Shadowed(std::integral auto constant) : value(T(constant)), exact(Rational(constant)) {}
    Shadowed(double given) : value(T(given)), exact(Rational(given)) {}
    Shadowed(T computed, std::optional<Rational> truth, const Judge* of)
        : value(computed), exact(std::move(truth)), judge(of) {}

    explicit operator double() const { return double(value); }

    Shadowed& operator+=(const Shadowed& other) { return *this = *this + other; }

    /// Not 0 - a: the run that is shadowed has -0.
    friend Shadowed operator-(const Shadowed& a) {
        std::optional<Rational> truth;
        if (a.exact) truth = Rational(-*a.exact);
        return {T(-a.value), std::move(truth), a.judge};
    }
    friend Shadowed operator+(const Shadowed& a, const Shadowed& b) { return computed(a, b, std::plus<>()); }
    friend Shadowed operator-(const Shadowed& a, const Shadowed& b) { return computed(a, b, std::minus<>()); }
    friend Shadowed operator*(const Shadowed& a, const Shadowed& b) { return computed(a, b, std::multiplies<>()); }
    friend Shadowed operator/(const Shadowed& a, const Shadowed& b) {
        if (b.exact && *b.exact == 0) return {a.value / b.value, std::nullopt, judge_of(a, b)};
        return computed(a, b, std::divides<>());
    }

    friend bool operator<(const Shadowed& a, const Shadowed& b) { return compared(a, b, std::less<>()); }
    friend bool operator>(const Shadowed& a, const Shadowed& b) { return compared(a, b, std::greater<>()); }
    friend bool operator<=(const Shadowed& a, const Shadowed& b) { return compared(a, b, std::less_equal<>()); }
    friend bool operator>=(const Shadowed& a, const Shadowed& b) { return compared(a, b, std::greater_equal<>()); }
    friend bool operator==(const Shadowed& a, const Shadowed& b) { return compared(a, b, std::equal_to<>()); }

private:
    static const Judge* judge_of(const Shadowed& a, const Shadowed& b) { return a.judge ? a.judge : b.judge; }

    static Shadowed computed(const Shadowed& a, const Shadowed& b, auto operation) {
        std::optional<Rational> truth;
        if (a.exact && b.exact) truth = Rational(operation(*a.exact, *b.exact));
        return {T(operation(a.value, b.value)), std::move(truth), judge_of(a, b)};
    }

    /// Comparing does not round: the answer is right for the operands.
    static bool compared(const Shadowed& a, const Shadowed& b, auto relation) {
        const bool taken = relation(a.value, b.value);
        if (const Judge* judge = judge_of(a, b)) {
            Verdict verdict{Decision::comparison, taken, {}};
            if (a.exact && b.exact) verdict.truth.answer = relation(*a.exact, *b.exact);
            (*judge)(verdict);
        }
        return taken;
    }
};

}  // namespace vidno
