/// RunTimeNumber: a number whose arithmetic is chosen at run time, so that procedures are compiled once for all of them.
///
/// In a judged run it also carries the truth: the same expression in exact rationals, along the path that was taken.
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <optional>

#include "format/verdict.h"
#include "vidno/kernels/bits.h"
#include "vidno/kernels/exact.h"

namespace vidno {

/// How results are rounded. A constant has no arithmetic of its own: it takes that of the number it is computed with.
struct Arithmetic {
    enum class Kind : unsigned char { constant, binary32, binary64, bits, exact };

    Kind kind = Kind::constant;
    int bits = 0;  // of Kind::bits

    bool is_exact() const { return kind == Kind::exact; }

    double rounded(double given) const {
        switch (kind) {
            case Kind::binary32: return double(float(given));
            case Kind::bits: return rounded_to(bits, given);
            default: return given;
        }
    }
    /// What one operation gives on two of its numbers.
    double result(double a, double b, auto operation) const {
        if (kind == Kind::binary32) return double(float(operation(float(a), float(b))));
        return rounded(operation(a, b));
    }
};

class RunTimeNumber {
public:
    RunTimeNumber() = default;
    RunTimeNumber(std::integral auto constant) : value_(double(constant)) {}
    RunTimeNumber(double constant) : value_(constant) {}

    /// A number of the scene or the screen. Its truth is the number as given.
    RunTimeNumber(const Arithmetic& arithmetic, double given, const Judge* judge = nullptr)
        : value_(arithmetic.rounded(given)), arithmetic_(arithmetic), judge_(judge) {
        if (judge || arithmetic.is_exact()) rational_ = kept(Rational(given));
    }

    /// An exact number.
    explicit RunTimeNumber(Rational exact) : arithmetic_{Arithmetic::Kind::exact}, rational_(kept(std::move(exact))) {}

    /// The same number, or its truth, with another value in use.
    RunTimeNumber with_value(double value) const { return {arithmetic_, value, rational_, judge_}; }

    /// A number of which nothing is known but what was computed.
    static RunTimeNumber without_truth(const Arithmetic& arithmetic, double computed, const Judge* judge) {
        return {arithmetic, computed, nullptr, judge};
    }

    bool is_exact() const { return arithmetic_.is_exact(); }
    const Judge* judge() const { return judge_; }

    /// For an exact number, the nearest double or one next to it.
    explicit operator double() const { return is_exact() ? CGAL::to_double(*rational_) : value_; }

    /// The number must not be exact.
    double value() const { return value_; }

    /// The number itself if it is exact; else its truth.
    std::optional<Rational> truth() const {
        if (rational_) return *rational_;
        return is_constant() ? std::optional(Rational(value_)) : std::nullopt;
    }
    bool has_truth() const { return rational_ || is_constant(); }

    /// The number must be exact.
    const Rational& rational() const { return *rational_; }

    /// The truth as an exact number; there must be one.
    RunTimeNumber exact_truth() const {
        if (!rational_) return RunTimeNumber(Rational(value_));
        return {{Arithmetic::Kind::exact}, 0, rational_, nullptr};
    }

    Sign sign() const {
        return is_exact() ? Sign{int(CGAL::sign(*rational_))} : Sign{int(value_ > 0) - int(value_ < 0)};
    }

    /// The number that is computed with, as if nobody judged it.
    RunTimeNumber not_judged() const { return {arithmetic_, value_, nullptr, nullptr}; }

    /// The same number in an arithmetic of which it is a constant.
    RunTimeNumber in(const Arithmetic& arithmetic, const Judge* judge) const {
        return is_constant() ? RunTimeNumber(arithmetic, value_, judge) : *this;
    }

    RunTimeNumber& operator+=(const RunTimeNumber& other) { return *this = *this + other; }

    /// Not 0 - a: a machine's number may become -0.
    friend RunTimeNumber operator-(RunTimeNumber a) {
        a.value_ = -a.value_;
        if (a.rational_) a.rational_ = kept(-*a.rational_);
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
        const bool undefined = judge_of(a, b) && b.rational_ && CGAL::is_zero(*b.rational_);
        if (!undefined) return computed(a, b, std::divides<>());
        const Arithmetic& arithmetic = common(a, b);
        return {arithmetic, arithmetic.result(a.value_, b.value_, std::divides<>()), nullptr, judge_of(a, b)};
    }

    friend int whole_part(const RunTimeNumber& a, int low, int end) {
        return a.is_exact() ? vidno::whole_part(*a.rational_, low, end) : vidno::whole_part(a.value_, low, end);
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

private:
    using Kept = std::shared_ptr<const Rational>;  // most numbers are copied more often than computed with

    static Kept kept(Rational value) { return std::make_shared<const Rational>(std::move(value)); }

    RunTimeNumber(const Arithmetic& arithmetic, double computed, Kept rational, const Judge* judge)
        : value_(computed), arithmetic_(arithmetic), rational_(std::move(rational)), judge_(judge) {}

    bool is_constant() const { return arithmetic_.kind == Arithmetic::Kind::constant; }

    static const Arithmetic& common(const RunTimeNumber& a, const RunTimeNumber& b) {
        return a.is_constant() ? b.arithmetic_ : a.arithmetic_;
    }
    static const Judge* judge_of(const RunTimeNumber& a, const RunTimeNumber& b) {
        return a.judge_ ? a.judge_ : b.judge_;
    }

    /// `use(p, q)` of the two as rationals; what a Result is by default if one of them is undefined.
    template <class Result>
    static Result of_rationals(const RunTimeNumber& a, const RunTimeNumber& b, auto&& use) {
        if (a.rational_ && b.rational_) return use(*a.rational_, *b.rational_);
        if (a.rational_ && b.is_constant()) return use(*a.rational_, Rational(b.value_));
        if (a.is_constant() && b.rational_) return use(Rational(a.value_), *b.rational_);
        return {};
    }

    /// Neither exact nor judged.
    bool is_plain() const { return !rational_ && !judge_; }

    static RunTimeNumber computed(const RunTimeNumber& a, const RunTimeNumber& b, auto operation) {
        if (!a.is_plain() || !b.is_plain()) return computed_exactly(a, b, operation);
        const Arithmetic& arithmetic = common(a, b);
        return {arithmetic, arithmetic.result(a.value_, b.value_, operation), nullptr, nullptr};
    }
    static RunTimeNumber computed_exactly(const RunTimeNumber& a, const RunTimeNumber& b, auto operation) {
        const auto exactly = [&] {
            return of_rationals<Kept>(a, b, [&](const Rational& p, const Rational& q) {
                return std::make_shared<const Rational>(operation(p, q));
            });
        };
        const Arithmetic& arithmetic = common(a, b);
        if (arithmetic.is_exact()) return {arithmetic, 0, exactly(), nullptr};
        const Judge* judge = judge_of(a, b);
        return {arithmetic, arithmetic.result(a.value_, b.value_, operation), judge ? exactly() : nullptr, judge};
    }

    /// Comparing does not round: the answer is right for the operands.
    static bool compared(const RunTimeNumber& a, const RunTimeNumber& b, auto relation) {
        return a.is_plain() && b.is_plain() ? relation(a.value_, b.value_) : compared_exactly(a, b, relation);
    }
    static bool compared_exactly(const RunTimeNumber& a, const RunTimeNumber& b, auto relation) {
        const auto exactly = [&] {
            return of_rationals<std::optional<bool>>(
                a, b, [&](const Rational& p, const Rational& q) { return std::optional<bool>(relation(p, q)); });
        };
        if (common(a, b).is_exact()) return *exactly();
        const bool taken = relation(a.value_, b.value_);
        if (const Judge* judge = judge_of(a, b)) {
            Verdict verdict{Decision::comparison, taken, {}};
            if (const auto right = exactly()) verdict.truth.answer = *right;
            (*judge)(verdict);
        }
        return taken;
    }

    double value_ = 0;
    Arithmetic arithmetic_;
    Kept rational_;                 // the number itself if it is exact; else its truth
    const Judge* judge_ = nullptr;  // of the run that the number belongs to; none for a constant
};

}  // namespace vidno
