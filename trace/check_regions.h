/// Runs of Weiler and Atherton's algorithm, told step by step at level `signs`, with every decision held against the truth.
#pragma once

#include "checked.h"
#include "event.h"
#include "run.h"

namespace vidno {

/// The verdicts on an event's decisions come before it. `count` hears under `filtered` what decided each comparison.
Picture judged_regions(const RunRequest& request, const Judge& judge, const Surveyor& survey,
                       const std::function<void(FilterStage)>& count, const std::function<void(const Event&)>& hear);

}  // namespace vidno
