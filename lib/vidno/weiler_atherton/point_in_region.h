/// PointInRegion: whether a region holds a point, and whether the point is on its outline.
#pragma once

#include "weiler_atherton_kernel.h"

namespace vidno {

/// Does a region hold a point that is not on its outline? If so, a ray to the right crosses the outline an odd number
/// of times.
template <WeilerAthertonKernel K>
bool holds(const K& kernel, const Region<typename K::Number>& region, const Point<typename K::Number>& point) {
    bool inside = false;
    const auto is_above = [&](const auto& v) { return kernel.order_of_rows(v.at, point) == Sign::negative; };
    for (const auto& loop : region.loops) {
        bool from_above = is_above(loop.back());
        for_each_edge(loop, [&](const auto& from, const auto& to) {
            const bool to_above = is_above(to);
            if (from_above != to_above && kernel.left_of(point, *from.after)) inside = !inside;
            from_above = to_above;
        });
    }
    return inside;
}

template <WeilerAthertonKernel K>
bool is_on_outline(const K& kernel, const Region<typename K::Number>& region, const Point<typename K::Number>& point) {
    bool found = false;
    for (const auto& loop : region.loops) {
        for_each_edge(loop, [&](const auto& from, const auto& to) {
            const Sign after_from = kernel.order(from.at, point);
            const Sign before_to = kernel.order(point, to.at);
            const bool between = after_from == before_to || after_from == Sign::zero || before_to == Sign::zero;
            found = found || (between && kernel.side(*from.after, point) == Sign::zero);
        });
    }
    return found;
}

}  // namespace vidno
