/// Judges the decisions of runs.
#pragma once

#include "run/run.h"

namespace vidno {

/// Reports a run to the request's sink and judges every decision. Under `filtered`, `grid` and `exact` the decisions are compared with
/// those of a run under `exact`, until they diverge.
Picture judged_run(const RunRequest& request, const Followers& followers);

/// Runs the same scene under `exact`, and gives the judge each decision with its numbers. The events are those of a run under any
/// kernel that is always right.
Picture exactly_judged_run(const RunRequest& request, const Followers& followers);

}  // namespace vidno
