/// Runs of the Warnock family, told step by step at level `signs`, under the kernels with which `vidno check` holds them
/// against the truth.
#pragma once

#include "checked.h"
#include "event.h"
#include "run.h"
#include "vidno/kernels/filtered.h"
#include "vidno/kernels/machine.h"

namespace vidno {

using HearEvent = std::function<void(const Event&)>;

Picture told_family(const RunRequest& request, const Checked<Float>& kernel, const HearEvent& hear);
Picture told_family(const RunRequest& request, const Checked<Double>& kernel, const HearEvent& hear);
Picture told_family(const RunRequest& request, const Checked<Bits>& kernel, const HearEvent& hear);
Picture told_family(const RunRequest& request, const FilteredBy<StageTally>& kernel, const HearEvent& hear);
Picture told_family(const RunRequest& request, const Grid& kernel, const HearEvent& hear);
Picture told_family(const RunRequest& request, const Exact& kernel, const HearEvent& hear);

}  // namespace vidno
