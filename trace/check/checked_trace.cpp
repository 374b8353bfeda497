#include "check/checked_trace.h"

#include <algorithm>
#include <utility>

#include "check/decision_of.h"
#include "check/judged_run.h"
#include "run/write_trace.h"

namespace vidno {

void CheckedTrace::hear(const EventView& event) {
    const auto decisions = heard_.told_by(event);
    event.visit([&]<class E>(const E& told) {
        if constexpr (requires { told.decides; }) {
            E judged = told;
            judged.told = told_of({E::decides, told.decision()}, decisions);
            write(judged);
        } else {
            write(told);
        }
    });
    last_stage_.reset();
    tell_wrong_ones(decisions);
}

void CheckedTrace::tell_wrong_ones(const std::vector<JudgedDecision>& decisions) {
    for (const auto& each : decisions) {
        if (!each.wrong()) continue;
        const auto operands = each.operands.empty() ? std::nullopt : std::optional(each.operands);
        writer_->hear(event::Disagree{at_, each.of, each.taken, *each.truth.answer, each.cause(), operands});
    }
}

bool CheckedTrace::is_told_early(Decision of) {
    using enum Decision;
    return of == inside || of == first_centre || of == last_centre || of == columns || of == comparison ||
           of == visibility;
}

template <class E>
void CheckedTrace::write(const E& event) {
    at_ = event.at;
    Detail from = E::kind.from;
    if constexpr (std::same_as<E, event::Call>) from = event::calls_from(event.of);
    if (from > detail_) return;
    if constexpr (std::same_as<E, event::Span>) {
        if (detail_ < Detail::polygons && event.depths) {
            E without_depths = event;
            without_depths.depths.reset();
            return writer_->hear(without_depths);
        }
    }
    writer_->hear(event);
}

namespace {

/// The operand under another name.
Operand renamed(Operand operand, std::string name) {
    operand.name = std::move(name);
    return operand;
}

/// The ends of a span give its columns: the first centre from one end and the last one up to the other.
JudgedDecision columns_of(const JudgedDecision& first, const JudgedDecision& last) {
    JudgedDecision columns = last;
    columns.taken = std::pair(std::get<int>(first.taken), std::get<int>(last.taken) + 1);
    columns.truth = {};
    if (first.truth.answer && last.truth.answer) {
        columns.truth.answer = std::pair(std::get<int>(*first.truth.answer), std::get<int>(*last.truth.answer) + 1);
    }
    if (!first.operands.empty() && !columns.operands.empty()) {
        columns.operands.front().name = "right";
        columns.operands.insert(columns.operands.begin(), renamed(first.operands.front(), "left"));
    }
    return columns;
}

/// The verdict on an event's decision: the last one of its kind. None if it was not judged, like columns in an edition that leaves out
/// the ends.
std::optional<JudgedDecision> judged(const ToldDecision& told, const std::vector<JudgedDecision>& decisions) {
    const auto found = [&](Decision of) -> const JudgedDecision* {
        const auto last = std::find_if(decisions.rbegin(), decisions.rend(), [&](auto& each) { return each.of == of; });
        return last == decisions.rend() ? nullptr : &*last;
    };
    if (const auto* own = found(told.of)) return *own;
    const auto* first = found(Decision::first_centre);
    const auto* last = found(Decision::last_centre);
    if (told.of != Decision::columns || !first || !last) return std::nullopt;
    const JudgedDecision columns = columns_of(*first, *last);
    return columns.taken == told.answer ? std::optional(columns) : std::nullopt;
}

/// The operands of each event that reports a decision.
std::vector<Operands> exact_operands(const RunRequest& request) {
    Pending<JudgedDecision> heard;
    std::vector<Operands> found;
    const Judge judge = [&](const Verdict& verdict) { heard.add(JudgedDecision(verdict)); };
    HeardBy sink([&](const EventView& event) {
        const auto decisions = heard.told_by(event);
        const auto told = decision_of(event);
        if (!told) return;
        const auto own = judged(*told, decisions);
        found.push_back(own ? own->operands : Operands{});
    });
    RunRequest exact = request;
    exact.detail = Detail::signs;
    exact.sink = &sink;
    exactly_judged_run(exact, {.judge = &judge});
    return found;
}

}  // namespace

Told CheckedTrace::told_of(const ToldDecision& told, const std::vector<JudgedDecision>& decisions) {
    const std::size_t place = decisions_++;
    const auto own = judged(told, decisions);
    if (!own) return {std::nullopt, last_stage_, std::nullopt};
    const Operands& operands = place < operands_.size() ? operands_[place] : own->operands;
    return {own->truth, last_stage_, operands.empty() ? std::nullopt : std::optional(operands)};
}

namespace {

/// `run(request, followers)` executes the run.
bool write_judged(auto request, TraceWriter& writer, std::vector<Operands> operands, auto&& run) {
    CheckedTrace trace(request.detail, writer, std::move(operands));
    const Judge judge = [&](const Verdict& verdict) { trace.judge(verdict); };
    const StageCount count = [&](FilterStage stage) { trace.count(stage); };
    request.detail = Detail::signs;
    request.sink = &trace;
    return write_run(writer, [&] {
        auto result = run(request, Followers{.judge = &judge, .count = &count});
        trace.tell_rest();
        return result;
    });
}

}  // namespace

bool write_checked_trace(const RunRequest& request, TraceWriter& writer) {
    auto operands = request.kernel.is_always_right() ? exact_operands(request) : std::vector<Operands>{};
    return write_judged(request, writer, std::move(operands), judged_run);
}

bool write_checked_trace(const FloatingHorizonRequest& request, TraceWriter& writer) {
    return write_judged(request, writer, {}, told_floating_horizon);
}

}  // namespace vidno
