/// RunTimeNumber: a number whose arithmetic is chosen at run time, so that procedures are compiled once for all
/// arithmetics.
///
/// In a judged run it also carries the truth: the same expression in exact rationals, along the path that was taken.
#pragma once

#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "format/verdict.h"
#include "run/arithmetic.h"
#include "run/exact_number.h"

namespace vidno {

/// The gap between the numbers left and right, in ulps of the greater one.
inline Gap gap_of(Coincidence if_zero, const Rational& left, const Rational& right, int digits) {
    const Rational exact = left - right;
    Gap gap{if_zero, {}, {Exact::fraction(exact)}, Sign{int(CGAL::sign(exact))}};
    if (gap.sign == Sign::zero) return gap;
    // Not CGAL::to_double, whose last digit depends on the library of rationals.
    const double greatest = nearest_double(std::max(Rational(CGAL::abs(left)), Rational(CGAL::abs(right))));
    gap.ulps = std::abs(nearest_double(exact)) / std::ldexp(1, std::ilogb(greatest) + 1 - digits);
    return gap;
}

class RunTimeNumber {
public:
    RunTimeNumber() = default;
    RunTimeNumber(std::integral auto constant) : value_(double(constant)) {}
    RunTimeNumber(double constant) : value_(constant) {}

    /// A number of the scene or the screen. Its truth is the given number.
    RunTimeNumber(const Arithmetic& arithmetic, double given, const Judge* judge = nullptr)
        : value_(arithmetic.rounded(given)), arithmetic_(arithmetic), judge_(judge) {
        if (judge || arithmetic.is_exact()) exact_ = ExactNumber(given);
    }

    /// An exact number.
    explicit RunTimeNumber(ExactNumber exact) : arithmetic_{Arithmetic::Kind::exact}, exact_(std::move(exact)) {}

    /// Another value in use, with this truth.
    RunTimeNumber with_value(double value) const { return {arithmetic_, value, exact_, judge_}; }

    /// A number whose truth is unknown: only the computed value.
    static RunTimeNumber without_truth(const Arithmetic& arithmetic, double computed, const Judge* judge) {
        return {arithmetic, computed, {}, judge};
    }

    bool is_exact() const { return arithmetic_.is_exact(); }
    const Judge* judge() const { return judge_; }

    /// For an exact number, the nearest double or one next to it.
    explicit operator double() const { return is_exact() ? double(exact_) : value_; }

    /// The number must not be exact.
    double value() const { return value_; }

    /// The number itself if it is exact; else its truth.
    std::optional<Rational> truth() const {
        const ExactNumber found = exactly();
        return found ? std::optional(found.rational()) : std::nullopt;
    }
    bool has_truth() const { return exact_ || is_constant(); }

    /// Whether it is its truth.
    bool is_right() const { return is(exactly()); }

    /// The number must be exact.
    const ExactNumber& exact() const { return exact_; }

    /// The truth as an exact number; there must be one.
    RunTimeNumber exact_truth() const { return RunTimeNumber(exactly()); }

    Sign sign() const { return is_exact() ? exact_.sign() : Sign{int(value_ > 0) - int(value_ < 0)}; }

    /// The number in use, without its truth.
    RunTimeNumber not_judged() const { return {arithmetic_, value_, {}, nullptr}; }

    /// The number as an operand of a decision, with a name.
    Operand operand(std::string name) const {
        const ExactNumber exact = exactly();
        const Fraction right{exact ? exact.fraction() : ""};
        return {std::move(name), is(exact) ? right : fraction_of(value_), right};
    }

    /// Not an initializer list, from which they would be copied.
    friend Operands two_operands(const RunTimeNumber& a, const char* a_name, const RunTimeNumber& b,
                                 const char* b_name) {
        Operands both;
        both.reserve(2);
        both.push_back(a.operand(a_name));
        both.push_back(b.operand(b_name));
        return both;
    }

    /// A constant as a number of an arithmetic.
    RunTimeNumber in(const Arithmetic& arithmetic, const Judge* judge) const {
        return is_constant() ? RunTimeNumber(arithmetic, value_, judge) : *this;
    }

    RunTimeNumber& operator+=(const RunTimeNumber& other) { return *this = *this + other; }

    /// Not 0 - a, since a machine's number may become -0.
    friend RunTimeNumber operator-(RunTimeNumber a) {
        a.value_ = -a.value_;
        if (a.exact_) a.exact_ = -a.exact_;
        return a;
    }
    friend RunTimeNumber operator+(const RunTimeNumber& a, const RunTimeNumber& b) {
        return computed(a, b, std::plus<>());
    }
    friend RunTimeNumber operator-(const RunTimeNumber& a, const RunTimeNumber& b) {
        return computed(a, b, std::minus<>());
    }
    friend RunTimeNumber operator*(const RunTimeNumber& a, const RunTimeNumber& b) {
        return computed(a, b, std::multiplies<>());
    }
    friend RunTimeNumber operator/(const RunTimeNumber& a, const RunTimeNumber& b) {
        const bool undefined = judge_of(a, b) && !common(a, b).is_exact() && b.exact_ && b.exact_.sign() == Sign::zero;
        if (!undefined) return computed(a, b, std::divides<>());
        const Arithmetic& arithmetic = common(a, b);
        return {arithmetic, arithmetic.result(a.value_, b.value_, std::divides<>()), {}, judge_of(a, b)};
    }

    friend int whole_part(const RunTimeNumber& a, int low, int end) {
        return a.is_exact() ? a.exact_.whole_part(low, end) : vidno::whole_part(a.value_, low, end);
    }

    friend bool operator<(const RunTimeNumber& a, const RunTimeNumber& b) { return compared(a, b, std::less<>()); }
    friend bool operator>(const RunTimeNumber& a, const RunTimeNumber& b) { return compared(a, b, std::greater<>()); }
    friend bool operator<=(const RunTimeNumber& a, const RunTimeNumber& b) {
        return compared(a, b, std::less_equal<>());
    }
    friend bool operator>=(const RunTimeNumber& a, const RunTimeNumber& b) {
        return compared(a, b, std::greater_equal<>());
    }
    friend bool operator==(const RunTimeNumber& a, const RunTimeNumber& b) { return compared(a, b, std::equal_to<>()); }
    friend bool select_lesser(const RunTimeNumber& a, const RunTimeNumber& b) {
        return compared(a, b, std::less<>(), Equal::decides_nothing);
    }

private:
    /// Whether the answer to a comparison of equal numbers matters.
    enum class Equal { decides, decides_nothing };

    RunTimeNumber(const Arithmetic& arithmetic, double computed, ExactNumber exact, const Judge* judge)
        : value_(computed), arithmetic_(arithmetic), exact_(std::move(exact)), judge_(judge) {}

    bool is_constant() const { return arithmetic_.is_of_constants(); }

    bool is(const ExactNumber& truth) const { return is_exact() || truth.as_double() == value_; }

    static const Arithmetic& common(const RunTimeNumber& a, const RunTimeNumber& b) {
        return a.is_constant() ? b.arithmetic_ : a.arithmetic_;
    }
    static const Judge* judge_of(const RunTimeNumber& a, const RunTimeNumber& b) {
        return a.judge_ ? a.judge_ : b.judge_;
    }

    /// The number itself if it is exact or a constant; else its truth, which may be undefined.
    ExactNumber exactly() const { return is_constant() ? ExactNumber(value_) : exact_; }

    /// `use(p, q)` of the two as exact numbers; a default Result if one of them is undefined.
    template <class Result>
    static Result of_exact(const RunTimeNumber& a, const RunTimeNumber& b, auto&& use) {
        const auto used = [&](const ExactNumber& p, const ExactNumber& q) {
            return p && q ? Result(use(p, q)) : Result();
        };
        if (a.is_constant()) return used(ExactNumber(a.value_), b.exactly());
        return b.is_constant() ? used(a.exact_, ExactNumber(b.value_)) : used(a.exact_, b.exact_);
    }

    /// Neither exact nor judged.
    bool is_plain() const { return !exact_ && !judge_; }

    static RunTimeNumber computed(const RunTimeNumber& a, const RunTimeNumber& b, auto operation) {
        if (!a.is_plain() || !b.is_plain()) return computed_exactly(a, b, operation);
        const Arithmetic& arithmetic = common(a, b);
        return {arithmetic, arithmetic.result(a.value_, b.value_, operation), {}, nullptr};
    }
    static RunTimeNumber computed_exactly(const RunTimeNumber& a, const RunTimeNumber& b, auto operation) {
        const auto exactly = [&] {
            return of_exact<ExactNumber>(
                a, b, [&](const auto& p, const auto& q) { return ExactNumber::result(p, q, operation); });
        };
        const Arithmetic& arithmetic = common(a, b);
        const Judge* judge = judge_of(a, b);
        if (arithmetic.is_exact()) return {arithmetic, 0, exactly(), judge};
        return {arithmetic, arithmetic.result(a.value_, b.value_, operation), judge ? exactly() : ExactNumber(), judge};
    }

    /// Comparing does not round: the answer is right for the operands.
    static bool compared(const RunTimeNumber& a, const RunTimeNumber& b, auto relation, Equal equal = Equal::decides) {
        return a.is_plain() && b.is_plain() ? relation(a.value_, b.value_) : compared_exactly(a, b, relation, equal);
    }
    static bool compared_exactly(const RunTimeNumber& a, const RunTimeNumber& b, auto relation, Equal equal) {
        const auto exactly = [&] {
            return of_exact<std::optional<bool>>(
                a, b, [&](const auto& p, const auto& q) { return ExactNumber::related(p, q, relation); });
        };
        const Judge* judge = judge_of(a, b);
        if (!judge && common(a, b).is_exact()) return *exactly();
        const auto right = exactly();
        const bool taken = common(a, b).is_exact() ? *right : relation(a.value_, b.value_);
        if (judge) {
            const NumbersCompared compared(a, b);
            const auto are_equal = [](const auto& p, const auto& q) {
                return ExactNumber::related(p, q, std::equal_to<>());
            };
            const bool is_listed = equal == Equal::decides || taken || !of_exact<bool>(a, b, are_equal);
            Verdict verdict{Decision::comparison, taken, {}, true, is_listed ? &compared : nullptr};
            if (right) verdict.truth.answer = *right;
            (*judge)(verdict);
        }
        return taken;
    }

    class NumbersCompared final : public Calculator {
    public:
        NumbersCompared(const RunTimeNumber& a, const RunTimeNumber& b) : a_(a), b_(b) {}

        Operands operands() const override { return two_operands(a_, "a", b_, "b"); }
        std::optional<Gap> gap() const override {
            const auto left = a_.truth(), right = b_.truth();
            if (!left || !right) return std::nullopt;
            const Arithmetic& arithmetic = common(a_, b_);
            Gap found = gap_of(Coincidence::equal_numbers, *left, *right, arithmetic.digits());
            found.computed = arithmetic.is_exact() ? Value(found.exact.text)
                                                   : Value(arithmetic.result(a_.value_, b_.value_, std::minus<>()));
            return found;
        }

    private:
        const RunTimeNumber& a_;
        const RunTimeNumber& b_;
    };

    double value_ = 0;
    Arithmetic arithmetic_;
    ExactNumber exact_;             // the number itself if it is exact; else its truth
    const Judge* judge_ = nullptr;  // that of the number's run; none for a constant
};

/// A constructed point as computed, and as it should be.
class PointConstructed final : public Calculator {
public:
    PointConstructed(const RunTimeNumber& x, const RunTimeNumber& y) : x_(x), y_(y) {}
    Operands operands() const override { return two_operands(x_, "x", y_, "y"); }
    std::optional<Gap> gap() const override { return std::nullopt; }

private:
    const RunTimeNumber& x_;
    const RunTimeNumber& y_;
};

}  // namespace vidno
