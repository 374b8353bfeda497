/// Judged runs, and runs traced to the end of a file.
#pragma once

#include "run/floating_horizon_run.h"
#include "run/run.h"

namespace vidno {

/// A run told to the request's sink, its every decision judged. Under `filtered`, `grid` and `exact` the decisions are compared with
/// those of a run under `exact`, until they part.
Picture judged_run(const RunRequest& request, const Followers& followers);

/// Traces a run to the end of its file. A checked trace gives each decision with its truth, and `disagree` after each wrong one.
/// False if the writer's limit ended the run, so that the trace is partial.
bool write_trace(RunRequest request, TraceWriter& writer, bool checked);
bool write_trace(FloatingHorizonRequest request, TraceWriter& writer, bool checked);

}  // namespace vidno
