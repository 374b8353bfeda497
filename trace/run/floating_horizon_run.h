/// Running the floating horizon as chosen at run time, with a trace or without.
#pragma once

#include "format/floating_horizon_trace.h"
#include "run/run.h"

namespace vidno {

struct FloatingHorizonRequest {
    NamedKernel kernel;  // one that runs curves, in this edition
    Edition edition;
    const CurveScene& scene;
    Detail detail = Detail::windows;
    EventSink* sink = nullptr;               // none: no trace
    std::function<void()> progress = [] {};  // without a trace, called at each curve; checked, at each step
};

/// Throws what the sink throws: a writer, EventLimitReached.
DrawnLines run(const FloatingHorizonRequest& request);

/// Of each curve, over which of its columns it is drawn.
using ColumnsDrawn = std::vector<std::vector<bool>>;
ColumnsDrawn columns_drawn(const DrawnLines& lines, const CurveScene& scene);

/// Of the same curves, over how many columns one is drawn and the other not.
std::uint64_t different_columns(const ColumnsDrawn& one, const ColumnsDrawn& other);

/// A run told to the request's sink; the followers hear its decisions, and what each decision in Visibility comes to.
DrawnLines told_floating_horizon(const FloatingHorizonRequest& request, const Followers& followers = {});

}  // namespace vidno
