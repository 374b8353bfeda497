/// Runs with a usual mistake, told step by step. One translation unit compiles all of them, so that it pays to have many.
#pragma once

#include "checked.h"
#include "event.h"
#include "run.h"
#include "vidno/kernels/machine.h"

namespace vidno {

using Hear = std::function<void(const Event&)>;

/// At level `signs`, under the kernels that `vidno check` holds such a run against the truth with.
Picture told_mistake(const RunRequest& request, const Exact& kernel, const Hear& hear);
Picture told_mistake(const RunRequest& request, const Checked<Double>& kernel, const Hear& hear);

}  // namespace vidno
