/// The decision of a step in words: its numbers, the run's answer and the exact one, and the calculation by hand.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "choice/language.h"
#include "format/trace_header.h"

namespace vidno {

class Replay;

namespace say {

/// Undefined: a wrong decision led to a division by zero before. Certain: the trace has no exact answer, but its kernel
/// is always right.
enum class Judged : unsigned char { right, wrong, undefined, certain, not_checked };
inline constexpr std::array<std::string_view, 5> judged_names{"right", "wrong", "undefined", "certain", "not_checked"};
constexpr auto& words_of(Judged) { return judged_names; }

/// The formula of FORMAT.md, *To redo a decision*, with the numbers in it, and the result: line by line.
struct Calculation {
    std::string title;
    std::vector<std::string> lines{};
    static void fields(auto& calculation, auto&& field) {
        field("title", calculation.title);
        field("lines", calculation.lines);
    }
};

struct SaidDecision {
    using Named = std::pair<std::string, std::string>;

    Decision of{};
    Answer taken;
    std::string title;
    std::vector<Named> numbers{};  // those whose sign or order it is, by their names in the listing
    std::vector<Named> answers{};  // what was computed, what is exact, what decided
    Judged judged{};
    std::string judgement{};
    std::vector<Calculation> calculations{};
    static void fields(auto& said, auto&& field) {
        field("of", said.of);
        field("taken", said.taken);
        field("title", said.title);
        field("numbers", said.numbers);
        field("answers", said.answers);
        field("judged", said.judged);
        field("judgement", said.judgement);
        field("calculations", said.calculations);
    }
};

/// An event, and those before and after it, as far as there are any.
struct DecidingStep {
    std::optional<Event> before, event, next;
};

/// None if the event decides nothing, or makes a right decision that it does not report. If the next event is a
/// `disagree`, it is about this decision.
std::optional<SaidDecision> decision(const DecidingStep& step, const AnyHeader& header, Language language);

/// The decision of a step of a run. At a `disagree` it is that of the step before.
std::optional<SaidDecision> decision(Replay& run, std::uint64_t step, Language language);

/// The calculation of a decision from its operands: that of the run, if they had drifted, and that with the exact ones.
/// `other` is the listing's name of the depth that z is compared with.
std::vector<Calculation> calculations(Decision of, const Operands& operands, Language language,
                                      const std::string& other = "z₀");

}  // namespace say
}  // namespace vidno
