/// What run_regions_<kernels>.cpp instantiate: Weiler and Atherton's algorithm, apart from the course's methods, so that these do not
/// wait for it to be compiled.
#pragma once

#include "recorder.h"
#include "run.h"
#include "vidno/weiler_atherton.h"

namespace vidno {

template <Kernel K, class Number>
std::vector<ShownRegion> shown(const VisibleRegions<Number>& visible) {
    std::vector<ShownRegion> regions;
    for (const auto& [polygon, outlines] : visible.regions) {
        auto& region = regions.emplace_back(ShownRegion{{polygon}, {}, as_value<K>(area_of(outlines))});
        for (const auto& outline : outlines) {
            region.loops.emplace_back();
            for (const auto& [x, y] : outline) region.loops.back().push_back({as_value<K>(x), as_value<K>(y)});
        }
    }
    return regions;
}

/// The visitor of a run without a trace: whoever waits for it sees that it goes on.
struct RegionPacer : NoTrace {
    const std::function<void()>& progress;

    void pop_list(Line, const auto&) { progress(); }
};

template <Kernel K>
Picture told_regions(const RunRequest& request, const K& kernel, const auto& trace) {
    const auto visible = visible_regions(request.scene, kernel, trace);
    if (request.regions) *request.regions = shown<K>(visible);
    return visible.picture;
}

template <Kernel K>
Picture traced_regions(const RunRequest& request, const K& kernel) {
    Recording<TraceWriter> recording{request.detail, *request.writer};
    return told_regions(request, kernel, Recorder<K, TraceWriter>(recording));
}

template <Kernel K>
Picture run_regions(const RunRequest& request, const K& kernel) {
    if (request.writer) return traced_regions(request, kernel);
    return told_regions(request, kernel, RegionPacer{{}, request.progress});
}

}  // namespace vidno
