/// Verdict: the judgement of exact arithmetic on one decision of a run.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "format/value.h"
#include "vidno/kernel.h"
#include "vidno/kernels/filter_stage.h"

namespace vidno {

/// The kind of a decision: a comparison of two numbers, or a question to the kernel, by its name there.
enum class Decision : unsigned char {
    comparison,
    orientation,
    nearer,
    outside,
    inside,
    first_centre,
    last_centre,
    rows,
    columns,
    same_rounded,
    pixel,
    visibility,
    left_of,
    parallel
};
inline constexpr std::array<std::string_view, 14> decision_names{
    "comparison", "orientation", "nearer",       "outside", "inside",     "first_centre", "last_centre",
    "rows",       "columns",     "same_rounded", "pixel",   "visibility", "left_of",      "parallel"};

/// Yes or no, a sign or a pixel, or a half-open range.
using Answer = std::variant<bool, int, std::pair<int, int>>;

/// The right answer along the path that was taken. None if it is undefined, because a wrong decision led to a division
/// by zero.
struct Truth {
    std::optional<Answer> answer;
    bool operator==(const Truth&) const = default;
};

/// A number as a fraction "p/q" in lowest terms, or "inf", "-inf" or "nan". Empty: undefined.
struct Fraction {
    std::string text;
    bool operator==(const Fraction&) const = default;
};

/// A number on which a decision was taken: as the run had it, and as it should have been along the path that was taken.
struct Operand {
    std::string name;
    Fraction used, exact;
    bool operator==(const Operand&) const = default;
};
using Operands = std::vector<Operand>;

/// The fields that a checked trace adds to a decision; empty in other traces.
struct CheckedFields {
    std::optional<Truth> exact{};
    std::optional<FilterStage> by{};  // under `filtered`: what decided
    std::optional<Operands> operands{};
};

/// Why a decision is wrong: its operation rounded, or it is right for its operands, which had drifted before.
enum class Cause : unsigned char { rounded, drifted };
inline constexpr std::array<std::string_view, 2> cause_names{"rounded", "drifted"};

/// The meaning of an equality of the two numbers of a decision.
enum class Coincidence : unsigned char {
    point_on_line,
    equal_depths,
    parallel_lines,
    shared_points,
    on_pixel_centre,
    box_on_window,
    curve_on_horizon,
    equal_numbers
};
inline constexpr std::array<std::string_view, 8> coincidence_names{
    "point_on_line",   "equal_depths",  "parallel_lines",   "shared_points",
    "on_pixel_centre", "box_on_window", "curve_on_horizon", "equal_numbers"};

/// The comparison of two numbers that determines a decision. The gap between them is the first minus the second.
struct Gap {
    Coincidence if_zero{};
    Value computed;  // by the run's arithmetic
    Fraction exact;
    Sign sign{};                 // of the exact one
    double ulps = 0;             // the exact one, in ulps of the run's numbers at the greater of the two
    std::optional<int> pixel{};  // the column or row, if the second number is the centre of one
};

/// The numbers from which a decision was computed. It refers to the run's own numbers, so query it only while the judge
/// hears the verdict.
class Calculator {
public:
    virtual Operands operands() const = 0;
    /// None where the truth is undefined, or a number is not finite.
    virtual std::optional<Gap> gap() const = 0;

protected:
    Calculator() = default;
    Calculator(const Calculator&) = default;
    Calculator& operator=(const Calculator&) = default;
    ~Calculator() = default;
};

struct Verdict {
    Decision of{};
    Answer taken;
    Truth truth;
    bool right_for_operands = true;
    const Calculator* calculator = nullptr;  // while the judge hears it

    bool wrong() const { return truth.answer && *truth.answer != taken; }
    Cause cause() const { return right_for_operands ? Cause::drifted : Cause::rounded; }  // if wrong
};

/// Hears the verdict on each decision of a run.
using Judge = std::function<void(const Verdict&)>;

}  // namespace vidno
