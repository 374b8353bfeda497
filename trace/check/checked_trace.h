/// CheckedTrace: writes a run that is judged, each decision with its truth, each wrong one followed by `disagree`.
#pragma once

#include <optional>
#include <vector>

#include "run/floating_horizon_run.h"
#include "run/run.h"

namespace vidno {

/// It hears every event of level `signs`, and before each event the verdicts on its decisions.
class CheckedTrace final : public EventSink {
public:
    CheckedTrace(Detail detail, TraceWriter& writer) : detail_(detail), writer_(&writer) {}

    void judge(const Verdict& verdict) { verdicts_.push_back(verdict); }
    void count(FilterStage stage) { last_stage_ = std::max(last_stage_.value_or(stage), stage); }

    void hear(const EventView& event) override;

    /// Those after the last event.
    void tell_wrong_ones();

private:
    template <class E>
    void write(const E& event);

    /// The truth of the event's decision; of a span's columns from those of its ends. None if it was not judged.
    std::optional<Truth> truth_of(Decision decision) const;

    Detail detail_;
    TraceWriter* writer_;
    std::vector<Verdict> verdicts_;          // since the last event
    std::optional<FilterStage> last_stage_;  // that was needed since
    Line at_{};
};

/// Traces a judged run to the end of its file. False if the writer's limit ended the run, so that the trace is partial.
bool write_checked_trace(const RunRequest& request, TraceWriter& writer);
bool write_checked_trace(const FloatingHorizonRequest& request, TraceWriter& writer);

}  // namespace vidno
