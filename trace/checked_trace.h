/// CheckedTrace: writes a run that is judged, each decision with its truth, each wrong one followed by `disagree`.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "trace_writer.h"

namespace vidno {

/// Calls `take(event)` if the event tells a decision.
void if_decision(auto&& event, auto&& take) {
    std::visit(
        [&](auto& e) {
            if constexpr (requires { e.decides; }) take(e);
        },
        event);
}

/// It is told every event of level `signs`, and before it the verdicts on its decisions.
class CheckedTrace {
public:
    CheckedTrace(Detail detail, TraceWriter& writer) : detail_(detail), writer_(&writer) {}

    void judge(const Verdict& verdict) { verdicts_.push_back(verdict); }
    void count(FilterStage stage) { last_stage_ = std::max(last_stage_.value_or(stage), stage); }

    void hear(Event event) {
        if_decision(event, [&](auto& e) { e.told = {truth_of(e.decides), last_stage_}; });
        last_stage_.reset();
        std::visit([&](auto& e) { write(e); }, event);
        tell_wrong_ones();
    }

    /// Those after the last event.
    void tell_wrong_ones() {
        for (const auto& verdict : std::exchange(verdicts_, {})) {
            if (!verdict.wrong()) continue;
            write(event::Disagree{at_, verdict.of, verdict.taken, *verdict.truth.answer, verdict.cause()});
        }
    }

private:
    template <class E>
    void write(E& event) {
        at_ = event.at;
        if constexpr (std::same_as<E, event::Span>) {
            if (detail_ < Detail::polygons) event.depths.reset();
        }
        Detail from = E::kind.from;
        if constexpr (std::same_as<E, event::Call>) from = event::calls_from(event.of);
        if (from <= detail_) (*writer_)(event);
    }
    void write(const event::Disagree& event) { (*writer_)(event); }

    /// The truth of the event's decision; of a span's columns from those of its ends. None if it was not judged.
    std::optional<Truth> truth_of(Decision decision) const {
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

    Detail detail_;
    TraceWriter* writer_;
    std::vector<Verdict> verdicts_;          // since the last event
    std::optional<FilterStage> last_stage_;  // that was needed since
    Line at_{};
};

}  // namespace vidno
