/// Verdict: what exact arithmetic says of one decision of a run.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "vidno/kernels/filter_stage.h"

namespace vidno {

/// What is decided: a comparison of two numbers, or a question to the kernel by its name there.
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

/// Yes or no, a sign or a pixel, or the half-open range that was found.
using Answer = std::variant<bool, int, std::pair<int, int>>;

/// The right answer along the path that was taken. None: undefined, for a wrong turn led to a division by zero.
struct Truth {
    std::optional<Answer> answer;
    bool operator==(const Truth&) const = default;
};

/// What a checked trace tells beside a decision; another trace, nothing.
struct Told {
    std::optional<Truth> exact;
    std::optional<FilterStage> by;  // under `filtered`: what decided
};

/// Why a decision is wrong: its operation rounded, or it is right for operands that had drifted before.
enum class Cause : unsigned char { rounded, drifted };
inline constexpr std::array<std::string_view, 2> cause_names{"rounded", "drifted"};

struct Verdict {
    Decision of{};
    Answer taken;
    Truth truth;
    bool right_for_operands = true;

    bool wrong() const { return truth.answer && *truth.answer != taken; }
    Cause cause() const { return right_for_operands ? Cause::drifted : Cause::rounded; }  // if wrong
};

/// Hears the verdict on each decision of a run.
using Judge = std::function<void(const Verdict&)>;

}  // namespace vidno
