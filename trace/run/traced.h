/// Runs that are reported to the request's sink: one translation unit per kernel, for all methods and editions.
///
/// `double`, `filtered` and `grid` are compiled for their own numbers, since a page runs them while a corner is
/// dragged. `float`, `bits` and `depth` share one kernel of rounded numbers (machine_kernel.h); `exact` and every
/// judged run share one whose numbers carry the truth (run_time_kernel.h).
#pragma once

#include "run/run.h"

namespace vidno {

Picture traced_double(const RunRequest&);
Picture traced_filtered(const RunRequest&, const StageCount* count);
Picture traced_grid(const RunRequest&);
Picture traced_machine(const RunRequest&);
Picture traced_run_time(const RunRequest&, const Followers&);

/// Weiler and Atherton's algorithm, under each kernel that runs it.
Picture traced_weiler_atherton(const RunRequest&, const Followers&);

}  // namespace vidno
