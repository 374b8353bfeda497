/// Weiler and Atherton's algorithm: which parts of the polygons are visible, by the procedures of a set in the
/// arithmetic of a kernel.
///
///     const auto visible = vidno::visible_regions(vidno::admit(scene), vidno::Double{});
///     for (const auto& region : visible.regions) ...
#pragma once

#include "admitted.h"
#include "corrected_weiler_atherton.h"
#include "kernels/machine.h"

namespace vidno {

/// The loops of a region, which is on the positive side of each edge: (q - p) x (v - p) > 0 for a v next to the edge
/// from p to q. Loops that bound holes have the opposite orientation.
template <class Number>
using Outlines = std::vector<std::vector<Point<Number>>>;

template <class Number>
Outlines<Number> outlines_of(const Region<Number>& region) {
    Outlines<Number> outlines;
    for (const auto& loop : region.loops) {
        outlines.emplace_back();
        for (const auto& vertex : loop) outlines.back().push_back(vertex.at);
    }
    return outlines;
}

/// In square pixels.
template <class Number>
Number area_of(const Outlines<Number>& outlines) {
    Number doubled = 0;
    for (const auto& loop : outlines) {
        const auto& origin = loop.front();
        for (std::size_t i = 2; i < loop.size(); ++i) {
            const auto& p = loop[i - 1];
            const auto& q = loop[i];
            doubled += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
        }
    }
    return doubled / Number(2);
}

/// A part of a polygon, in the area.
template <class Number>
struct VisibleRegion {
    int polygon;  // its place in the scene
    Outlines<Number> outlines;
};

/// The regions in the order in which they were found, and their picture.
template <class Number>
struct VisibleRegions {
    std::vector<VisibleRegion<Number>> regions;
    Picture picture;
};

/// Runs weiler_atherton/weiler_atherton.h and reports each step to the trace. The numbers are the kernel's.
template <class Set = CorrectedWeilerAtherton, Kernel K, class Trace = NoTrace>
VisibleRegions<typename OnRegions<K>::Number> visible_regions(const AdmittedScene& scene, K kernel, Trace trace = {}) {
    VisibleRegions<typename OnRegions<K>::Number> result{{}, Picture(scene->area, scene->background)};
    WeilerAthertonRun<Set, OnRegions<K>, Trace> run(scene, OnRegions<K>(std::move(kernel)), std::move(trace),
                                                    result.picture);
    try {
        run.set.weiler_atherton(run);
    } catch (const Fault& fault) {
        run.trace.fault(fault.at, fault.reason);
    }
    for (const auto& piece : run.visible) result.regions.push_back({piece.polygon->index, outlines_of(piece.region)});
    return result;
}

}  // namespace vidno
