#include "say/decision.h"

#include "check/decision_of.h"
#include "choice/kernel_choice.h"
#include "format/decision_words.h"
#include "replay/replay.h"
#include "say/words.h"

namespace vidno::say {

namespace {

/// The numbers of a decision as its event has them.
struct DecidedNumbers {
    const Words& words;
    const std::optional<Event>& before;  // the event before

    using Numbers = std::vector<SaidDecision::Named>;

    Numbers operator()(const event::Orient& e) const { return {number("f", e.value)}; }
    Numbers operator()(const event::ClipSign& e) const { return {number("f", e.value)}; }
    Numbers operator()(const event::Compare& e) const { return {number("z", e.z), number("z₀", e.against)}; }
    Numbers operator()(const event::Box& e) const {
        return {number("x₁", e.box[0]), number("y₁", e.box[1]), number("x₂", e.box[2]), number("y₂", e.box[3])};
    }
    Numbers operator()(const event::Row& e) const { return {number("x₁", e.left), number("x₂", e.right)}; }
    Numbers operator()(const event::Pixel& e) const { return {number("z", e.z), number("Z", e.stored)}; }
    Numbers operator()(const event::Behind& e) const { return {number("z", e.z), number("z′", e.clip_z)}; }
    Numbers operator()(const event::Order& e) const { return {number("z", e.z), number("z′", e.other_z)}; }
    /// The heights of the curve, and of the horizons that exist.
    Numbers operator()(const event::Visibility&) const {
        const auto* height = before ? before->get_if<event::Height>() : nullptr;
        if (height == nullptr) return {};
        Numbers numbers{number("y", height->y)};
        if (height->upper) numbers.push_back(number(words.say("upper", "верхний"), *height->upper));
        if (height->lower) numbers.push_back(number(words.say("lower", "нижний"), *height->lower));
        return numbers;
    }
    Numbers operator()(const auto&) const { return {}; }

private:
    SaidDecision::Named number(const std::string& name, const Value& value) const {
        return {name, all_digits(value, words.language())};
    }
};

/// What a trace has of a decision.
struct Recorded {
    Decision of;
    Answer taken;
    std::optional<Truth> exact{};
    std::optional<FilterStage> by{};
    std::optional<Operands> operands{};
    std::optional<Cause> cause{};
};

std::optional<Recorded> recorded_in(const std::optional<Event>& event) {
    const auto own = event ? decision_of(*event) : std::nullopt;
    if (!own) return std::nullopt;
    return Recorded{own->of, own->answer, own->checked.exact, own->checked.by, own->checked.operands};
}

/// A step may decide more than one thing, or something without an event of its own. The wrong decision is the one to
/// say.
Recorded recorded_by(const event::Disagree& e) {
    return {e.of, e.taken, Truth{e.exact}, std::nullopt, e.operands, e.cause};
}

std::string answer_of(const Recorded& recorded, const Answer& answer, const Words& words) {
    constexpr std::array<Bilingual, 3> signs{{{"negative", "минус"}, {"zero", "нуль"}, {"positive", "плюс"}}};
    const auto* sign = std::get_if<int>(&answer);
    if (recorded.of == Decision::orientation && sign != nullptr)
        return std::string(words.in(signs[std::size_t(*sign) + 1]));
    return std::visit(AnswerWords{words}, answer);
}

Judged judged(const Recorded& recorded, const AnyHeader& header) {
    if (!recorded.exact) {
        const std::string& kernel = std::visit([](const auto& of) -> const std::string& { return of.kernel; }, header);
        return is_always_right(kernel) ? Judged::certain : Judged::not_checked;
    }
    if (!recorded.exact->answer) return Judged::undefined;
    return *recorded.exact->answer == recorded.taken ? Judged::right : Judged::wrong;
}

std::string judgement(Judged is, const Recorded& recorded, const Words& words) {
    switch (is) {
        case Judged::right: return words.say("✓ Right.", "✓ Верно.");
        case Judged::wrong:
            return words.say("✗ Wrong. {}", "✗ Неверно. {}",
                             recorded.cause ? words.in(cause_words[std::size_t(*recorded.cause)]) : std::string_view{});
        case Judged::undefined:
            return words.say("The run took a wrong branch before, so there is no right answer here.",
                             "После неверной ветви верного ответа здесь нет.");
        case Judged::certain:
            return words.say("With these numbers every decision is exact.", "С этими числами каждое решение точно.");
        case Judged::not_checked: return words.say("Not checked.", "Не проверено.");
    }
    return {};
}

constexpr std::array<Bilingual, filter_stage_names.size()> stage_words{{
    {"the given coordinates", "координатами, как они заданы"},
    {"a bound for the whole scene", "границей погрешности для всей сцены"},
    {"a bound for these numbers", "границей погрешности этих чисел"},
    {"exact arithmetic", "точной арифметикой"},
}};

}  // namespace

std::optional<SaidDecision> decision(const DecidingStep& step, const AnyHeader& header, Language language) {
    const Words words(language);
    const auto own = recorded_in(step.event);
    const auto* wrong = step.next ? step.next->get_if<event::Disagree>() : nullptr;
    if (!own && wrong == nullptr) return std::nullopt;
    const Recorded recorded = wrong != nullptr ? recorded_by(*wrong) : *own;
    SaidDecision said{recorded.of, recorded.taken,
                      capital(std::string(words.in(decision_words[std::size_t(recorded.of)])))};
    if (own) said.numbers = step.event->visit(DecidedNumbers{words, step.before});
    said.answers.emplace_back(words.say("Computed", "Вычислено"), answer_of(recorded, recorded.taken, words));
    if (recorded.exact && recorded.exact->answer) {
        said.answers.emplace_back(words.say("Exactly", "Точно"), answer_of(recorded, *recorded.exact->answer, words));
    }
    if (recorded.by) {
        said.answers.emplace_back(words.say("Decided by", "Чем решено"),
                                  words.in(stage_words[std::size_t(*recorded.by)]));
    }
    said.judged = judged(recorded, header);
    said.judgement = judgement(said.judged, recorded, words);
    if (recorded.operands && !recorded.operands->empty()) {
        const std::string other = said.numbers.size() > 1 ? said.numbers[1].first : "z₀";
        said.calculations = calculations(recorded.of, *recorded.operands, language, other);
    }
    return said;
}

std::optional<SaidDecision> decision(Replay& run, std::uint64_t step, Language language) {
    const auto event_at = [&](std::uint64_t each) {
        return each >= 1 && each <= run.length() ? std::optional(run.event(each).copy()) : std::nullopt;
    };
    auto event = event_at(step);
    if (event && event->get_if<event::Disagree>()) event = event_at(--step);
    return decision({event_at(step - 1), event, event_at(step + 1)}, run.header(), language);
}

}  // namespace vidno::say
