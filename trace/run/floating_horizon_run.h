/// Runs the floating horizon as chosen at run time, with or without a trace.
#pragma once

#include "format/floating_horizon_trace.h"
#include "run/run.h"

namespace vidno {

struct FloatingHorizonRequest {
    NamedKernel kernel;  // one that runs curves, in this edition
    Edition edition;
    const AdmittedCurves& scene;
    Detail detail = Detail::windows;
    EventSink* sink = nullptr;               // none: no trace
    std::function<void()> progress = [] {};  // without a trace, called at each curve; checked, at each step
};

/// Throws whatever the sink throws; a writer throws EventLimitReached.
DrawnLines run(const FloatingHorizonRequest& request);

/// What the run of the request loses (see RunLosses), if it draws these lines. Steps are counted at level `signs`.
std::vector<Loss> losses_of(FloatingHorizonRequest request, const DrawnLines& lines);

/// For each curve, the columns over which it is drawn.
using ColumnsDrawn = std::vector<std::vector<bool>>;
ColumnsDrawn columns_drawn(const DrawnLines& lines, const CurveScene& scene);

/// The number of columns over which corresponding curves are drawn in only one of two drawings.
std::uint64_t different_columns(const ColumnsDrawn& one, const ColumnsDrawn& other);

/// Reports a run to the request's sink; the followers hear its decisions, and the result of each decision in
/// Visibility.
DrawnLines traced_floating_horizon(const FloatingHorizonRequest& request, const Followers& followers = {});

}  // namespace vidno
