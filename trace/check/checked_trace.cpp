#include "check/checked_trace.h"

#include <algorithm>
#include <utility>

#include "check/judged_run.h"
#include "run/write_trace.h"

namespace vidno {

void CheckedTrace::hear(const EventView& event) {
    event.visit([&]<class E>(const E& told) {
        if constexpr (requires { told.decides; }) {
            E judged = told;
            judged.told = {truth_of(E::decides), last_stage_};
            write(judged);
        } else {
            write(told);
        }
    });
    last_stage_.reset();
    tell_wrong_ones();
}

void CheckedTrace::tell_wrong_ones() {
    for (const auto& verdict : std::exchange(verdicts_, {})) {
        if (!verdict.wrong()) continue;
        writer_->hear(event::Disagree{at_, verdict.of, verdict.taken, *verdict.truth.answer, verdict.cause()});
    }
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

std::optional<Truth> CheckedTrace::truth_of(Decision decision) const {
    const auto found = [&](Decision of) -> const Truth* {
        const auto last = std::find_if(verdicts_.rbegin(), verdicts_.rend(), [&](auto& v) { return v.of == of; });
        return last == verdicts_.rend() ? nullptr : &last->truth;
    };
    if (const Truth* truth = found(decision)) return *truth;
    const Truth* first = found(Decision::first_centre);
    const Truth* last = found(Decision::last_centre);
    if (decision != Decision::columns || !first || !last) return std::nullopt;
    if (!first->answer || !last->answer) return Truth{};
    return Truth{std::pair(std::get<int>(*first->answer), std::get<int>(*last->answer) + 1)};
}

namespace {

/// `run(request, followers)` makes the run.
bool write_judged(auto request, TraceWriter& writer, auto&& run) {
    CheckedTrace trace(request.detail, writer);
    const Judge judge = [&](const Verdict& verdict) { trace.judge(verdict); };
    const StageCount count = [&](FilterStage stage) { trace.count(stage); };
    request.detail = Detail::signs;
    request.sink = &trace;
    return write_run(writer, [&] {
        auto result = run(request, Followers{.judge = &judge, .count = &count});
        trace.tell_wrong_ones();
        return result;
    });
}

}  // namespace

bool write_checked_trace(const RunRequest& request, TraceWriter& writer) {
    return write_judged(request, writer, judged_run);
}

bool write_checked_trace(const FloatingHorizonRequest& request, TraceWriter& writer) {
    return write_judged(request, writer, told_floating_horizon);
}

}  // namespace vidno
