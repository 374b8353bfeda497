/// Judged runs.
#pragma once

#include "run/run.h"

namespace vidno {

/// A run told to the request's sink, its every decision judged. Under `filtered`, `grid` and `exact` the decisions are compared with
/// those of a run under `exact`, until they part.
Picture judged_run(const RunRequest& request, const Followers& followers);

/// The same scene under `exact`, each decision told to the judge with the numbers that it was taken on. Its events are those of a run
/// under any kernel that is always right.
Picture exactly_judged_run(const RunRequest& request, const Followers& followers);

}  // namespace vidno
