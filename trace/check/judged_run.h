/// Judges the decisions of runs.
#pragma once

#include <vector>

#include "run/run.h"

namespace vidno {

/// Reports a run to the request's sink and judges every decision. Under `filtered`, `grid` and `exact` the decisions
/// are compared with those of a run under `exact`, until they diverge.
Picture judged_run(const RunRequest& request, const Followers& followers);

/// Runs the same scene under `exact`, and gives the judge each decision with its numbers. The events are those of a run
/// under any kernel that is always right.
Picture exactly_judged_run(const RunRequest& request, const Followers& followers);

/// What `exact` decides.
struct RightDecisions {
    std::vector<Answer> reported;  // by events
    std::vector<Sign> signs;       // Weiler and Atherton's algorithm takes more decisions than its events report
};

/// Runs the same scene under `exact`, reported to the request's sink. The judge, if there is one, hears at least the
/// decisions that events report.
RightDecisions right_decisions(const RunRequest& request, const Judge* judge);

/// The part of `judged_run` after the run under `exact`.
Picture compared_run(const RunRequest& request, const RightDecisions& right, const Followers& followers);

}  // namespace vidno
