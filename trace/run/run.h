/// Running a method as chosen at run time, with a trace or without.
#pragma once

#include <functional>
#include <vector>

#include "choice/kernel_choice.h"
#include "format/trace_writer.h"
#include "run/followers.h"

namespace vidno {

/// A visible region of Weiler and Atherton's algorithm, in the numbers of its kernel: loops, holes the other way round; its
/// area in square pixels.
struct ShownRegion {
    PolygonPlace polygon;
    RegionLoops loops;
    Value area;
};

struct RunRequest {
    Method method;
    NamedKernel kernel;
    Edition edition;
    const Scene& scene;
    Detail detail = Detail::windows;
    EventSink* sink = nullptr;  // none: no trace
    /// Of Warnock's algorithm, the side; a trace does not say it.
    double smallest_window = 1;
    /// Called at each window, polygon or list of a run without a trace, and at each step of one that is checked.
    std::function<void()> progress = [] {};
    /// Where those of Weiler and Atherton's algorithm go, if they are wanted.
    std::vector<ShownRegion>* regions = nullptr;
};

/// Throws what the sink throws: a writer, EventLimitReached.
Picture run(const RunRequest& request);

/// The same for a request that has a sink; the followers hear of its decisions.
Picture told_run(const RunRequest& request, const Followers& followers = {});

}  // namespace vidno
