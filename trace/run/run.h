/// Runs a method as chosen at run time, with or without a trace.
#pragma once

#include <functional>
#include <vector>

#include "choice/kernel_choice.h"
#include "format/trace_writer.h"
#include "loss.h"
#include "run/followers.h"
#include "vidno/admitted.h"

namespace vidno {

/// A visible region of Weiler and Atherton's algorithm, in the numbers of its kernel: its loops, with the opposite
/// orientation for holes, and its area in square pixels.
struct ShownRegion {
    PolygonPlace polygon;
    RegionLoops loops;
    Value area;
};

struct RunRequest {
    Method method;
    NamedKernel kernel;
    Edition edition;
    const AdmittedScene& scene;
    Detail detail = Detail::windows;
    EventSink* sink = nullptr;  // none: no trace
    /// The side of the smallest window of Warnock's algorithm. A trace does not contain it.
    double smallest_window = 1;
    /// Called at each window, polygon or list of a run without a trace, and at each step of a checked run.
    std::function<void()> progress = [] {};
    /// Receives the regions of Weiler and Atherton's algorithm, if not null.
    std::vector<ShownRegion>* regions = nullptr;
    /// Becomes true, if not null, if a run without a trace loses something; `losses_of` says what.
    bool* loses = nullptr;
};

/// What the run of the request loses (see RunLosses). Steps are counted at level `signs`. It runs once more, with a
/// trace.
std::vector<Loss> losses_of(RunRequest request);

/// Throws whatever the sink throws; a writer throws EventLimitReached.
Picture run(const RunRequest& request);

/// Runs a request with a sink; the followers hear of its decisions.
Picture traced_run(const RunRequest& request, const Followers& followers = {});

}  // namespace vidno
