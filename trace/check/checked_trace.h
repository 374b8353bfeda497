/// CheckedTrace: writes a judged run: each decision with its truth, each wrong one followed by `disagree`.
#pragma once

#include <optional>
#include <vector>

#include "check/decision_of.h"
#include "check/judged_decision.h"
#include "check/pending.h"
#include "run/floating_horizon_run.h"
#include "run/run.h"

namespace vidno {

/// The decisions that the events of a trace report. Only these and wrong ones need their operands, which take most of
/// the time.
struct ReportedDecisions {
    Detail detail;
    bool of_regions = false;  // of Weiler and Atherton's algorithm

    bool has(Decision of) const;
};

/// It hears every event of level `signs`, and before each event the verdicts on its decisions.
class CheckedTrace final : public EventSink {
public:
    /// `operands` and `right` hold the operands and the right answer of each event that reports a decision, in the
    /// order of the events, from a run under `exact`. If they are empty, those of the verdicts are used.
    CheckedTrace(ReportedDecisions reported, TraceWriter& writer, std::vector<Operands> operands = {},
                 std::vector<Answer> right = {})
        : reported_(reported), writer_(&writer), operands_(std::move(operands)), right_(std::move(right)) {}

    void judge(const Verdict& verdict) {
        pending_.add(JudgedDecision(verdict, reported_.has(verdict.of) || verdict.wrong()));
    }
    void count(FilterStage stage) { last_stage_ = std::max(last_stage_.value_or(stage), stage); }

    void hear(const EventView& event) override;

    /// Writes the wrong decisions after the last event.
    void tell_rest() { tell_wrong_ones(pending_.rest()); }

private:
    template <class E>
    void write(const E& event);

    void tell_wrong_ones(const std::vector<JudgedDecision>& decisions);

    /// The fields that a checked trace adds to the event's decision. It takes the operands of the right ones.
    CheckedFields checked_fields_of(const ReportedDecision& reported, std::vector<JudgedDecision>& decisions);

    ReportedDecisions reported_;
    TraceWriter* writer_;
    std::vector<Operands> operands_;
    std::vector<Answer> right_;
    std::size_t decisions_ = 0;  // reported by events so far
    Pending<JudgedDecision> pending_;
    std::optional<FilterStage> last_stage_;  // the last one needed since the last event
    Line at_{};
};

/// Traces a judged run to the end of its file. False if the writer's limit ended the run, so that the trace is partial.
bool write_checked_trace(const RunRequest& request, TraceWriter& writer);
bool write_checked_trace(const FloatingHorizonRequest& request, TraceWriter& writer);

}  // namespace vidno
