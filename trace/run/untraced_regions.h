/// Weiler and Atherton's algorithm without a trace.
#pragma once

#include "run/regions_run.h"
#include "run/untraced.h"

namespace vidno {

/// The visitor of a run without a trace: whoever waits for it sees that it goes on.
struct RegionPacer : NoTrace {
    const std::function<void()>& progress;

    void pop_list(Line, const auto& /*pieces*/) { progress(); }
};

template <Kernel K>
Picture untraced_regions(const RunRequest& request, const K& kernel) {
    return regions_run(request, kernel, RegionPacer{{}, request.progress});
}

}  // namespace vidno
