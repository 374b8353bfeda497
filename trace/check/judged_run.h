/// Judged runs.
#pragma once

#include "run/run.h"

namespace vidno {

/// A run told to the request's sink, its every decision judged. Under `filtered`, `grid` and `exact` the decisions are compared with
/// those of a run under `exact`, until they part.
Picture judged_run(const RunRequest& request, const Followers& followers);

}  // namespace vidno
