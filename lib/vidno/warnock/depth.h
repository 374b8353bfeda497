/// Depth: z := -(a x + b y + d) / c.
///
/// Takes   a polygon that is not edge-on (c is not 0) and a point.
/// Gives   the depth of the polygon's plane at the point, whether or not the polygon contains it.
#pragma once

namespace vidno {

struct Depth {
    static auto depth(auto& run, const auto& polygon, const auto& point) {
        return run.kernel.depth(polygon.plane, point);  // D1
    }
};

}  // namespace vidno
