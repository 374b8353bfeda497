#include "check/checked_trace.h"

#include <algorithm>
#include <utility>

#include "check/decision_of.h"
#include "check/judged_run.h"
#include "run/write_trace.h"

namespace vidno {

bool ReportedDecisions::has(Decision of) const {
    using enum Decision;
    if (detail == Detail::windows) return false;
    if (of_regions && of == orientation) return false;  // only the surround test and the clip report theirs
    return detail == Detail::signs || of == inside || of == first_centre || of == last_centre || of == columns ||
           of == comparison || of == visibility;
}

void CheckedTrace::hear(const EventView& event) {
    auto decisions = pending_.reported_by(event);
    event.visit([&]<class E>(const E& e) {
        if constexpr (requires { e.decides; }) {
            E judged = e;
            judged.checked = checked_fields_of({E::decides, e.decision(), e.checked}, decisions);
            write(judged);
        } else {
            write(e);
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

template <class E>
void CheckedTrace::write(const E& event) {
    at_ = event.at;
    if (event::level_of(event) > reported_.detail) return;
    if constexpr (std::same_as<E, event::Span>) {
        if (reported_.detail < Detail::polygons && event.depths) {
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
JudgedDecision columns_of(JudgedDecision first, JudgedDecision columns) {
    columns.taken = std::pair(std::get<int>(first.taken), std::get<int>(columns.taken) + 1);
    const Truth last = std::exchange(columns.truth, {});
    if (first.truth.answer && last.answer) {
        columns.truth.answer = std::pair(std::get<int>(*first.truth.answer), std::get<int>(*last.answer) + 1);
    }
    if (!first.operands.empty() && !columns.operands.empty()) {
        columns.operands.front().name = "right";
        columns.operands.insert(columns.operands.begin(), renamed(std::move(first.operands.front()), "left"));
    }
    return columns;
}

/// The verdict on an event's decision: the last one of its kind. None if it was not judged, like columns in an edition
/// that leaves out the ends. Only wrong decisions keep their operands.
std::optional<JudgedDecision> judged(const ReportedDecision& reported, std::vector<JudgedDecision>& decisions) {
    const auto find = [&](Decision of) {
        return std::find_if(decisions.rbegin(), decisions.rend(), [&](auto& each) { return each.of == of; });
    };
    const auto take = [](auto found) { return found->wrong() ? *found : std::move(*found); };
    const auto none = decisions.rend();
    if (const auto own = find(reported.of); own != none) return take(own);
    const auto first = find(Decision::first_centre), last = find(Decision::last_centre);
    if (reported.of != Decision::columns || first == none || last == none) return std::nullopt;
    JudgedDecision columns = columns_of(take(first), take(last));
    return columns.taken == reported.answer ? std::optional(std::move(columns)) : std::nullopt;
}

ReportedDecisions reported_decisions(const RunRequest& request, Detail detail) {
    return {detail, algorithm_of(request.method) == Algorithm::weiler_atherton};
}
ReportedDecisions reported_decisions(const FloatingHorizonRequest&, Detail detail) { return {detail}; }

/// What `exact` decides, and the operands of each event that reports a decision.
struct Exactly {
    RightDecisions right;
    std::vector<Operands> operands;
};

Exactly exactly(RunRequest request) {
    Pending<JudgedDecision> pending;
    std::vector<Operands> operands;
    const ReportedDecisions reported = reported_decisions(request, Detail::signs);
    const Judge judge = [&](const Verdict& verdict) { pending.add(JudgedDecision(verdict, reported.has(verdict.of))); };
    FunctionSink sink([&](const EventView& event) {
        auto decisions = pending.reported_by(event);
        const auto decision = decision_of(event);
        if (!decision) return;
        auto own = judged(*decision, decisions);
        operands.push_back(own ? std::move(own->operands) : Operands{});
    });
    request.detail = Detail::signs;
    request.sink = &sink;
    auto right = right_decisions(request, &judge);
    return {std::move(right), std::move(operands)};
}

}  // namespace

CheckedFields CheckedTrace::checked_fields_of(const ReportedDecision& reported,
                                              std::vector<JudgedDecision>& decisions) {
    const std::size_t place = decisions_++;
    auto own = judged(reported, decisions);
    // Signs alone do not tell the columns of a row of a region; the run under `exact` reported them at the same event.
    const bool is_reported_exactly = place < right_.size();
    if (!own && !is_reported_exactly) return {std::nullopt, last_stage_, std::nullopt};
    Operands operands = place < operands_.size() ? std::move(operands_[place])
                        : own                    ? std::move(own->operands)
                                                 : Operands{};
    return {own ? own->truth : Truth{right_[place]}, last_stage_,
            operands.empty() ? std::nullopt : std::optional(std::move(operands))};
}

namespace {

/// `run(request, followers)` executes the run.
bool write_judged(auto request, TraceWriter& writer, CheckedTrace trace, auto&& run) {
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
    const ReportedDecisions reported = reported_decisions(request, request.detail);
    if (!request.kernel.is_always_right()) return write_judged(request, writer, {reported, writer}, judged_run);
    auto [right, operands] = exactly(request);
    return write_judged(
        request, writer, {reported, writer, std::move(operands), right.reported},
        [&right = right](const auto& of, const auto& followers) { return compared_run(of, right, followers); });
}

bool write_checked_trace(const FloatingHorizonRequest& request, TraceWriter& writer) {
    return write_judged(request, writer, {reported_decisions(request, request.detail), writer},
                        traced_floating_horizon);
}

}  // namespace vidno
