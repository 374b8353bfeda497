/// Runs Weiler and Atherton's algorithm for a request, and reports it to a visitor.
#pragma once

#include "run/run.h"
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

template <Kernel K>
Picture weiler_atherton_run(const RunRequest& request, const K& kernel, const auto& trace) {
    const auto visible = visible_regions(request.scene, kernel, trace);
    if (request.regions) *request.regions = shown<K>(visible);
    return visible.picture;
}

}  // namespace vidno
