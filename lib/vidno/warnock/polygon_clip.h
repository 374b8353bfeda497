/// PolygonClip: the part of a convex polygon that lies in a window.
///
/// Source  I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, CACM 17(1), 1974.
/// Takes   a polygon and a window; the window's sides are directed so that a positive cross product lies outside.
/// Gives   the vertices in the polygon's order, none if the polygon lies outside; vertices on a side are kept.
/// Time    one cross product for each vertex and side.
#pragma once

#include "../run.h"

namespace vidno {

struct PolygonClip {
    template <class Run>
    static typename Run::Outline polygon_clip(Run& run, const Polygon<typename Run::Arithmetic>& polygon,
                                              const Window& window) {
        using enum Line;
        auto& kernel = run.kernel;
        auto& trace = run.trace;

        const auto corners = run.set.corners_around(kernel, window);
        auto vertices = kernel.outline(polygon.vertices);
        trace.clip_begin(PL1, polygon, window);

        for (int side = 0; side < 4; ++side) {
            const auto& corner = corners[side];            // F_i
            const auto& before = corners[(side + 3) % 4];  // f0
            trace.clip_side(PL2, side + 1, before, corner);

            typename Run::Outline clipped;
            auto from = vertices.back();
            auto from_cross = kernel.cross(corner, from, before);
            trace.clip_sign(PL3, from, from_cross, kernel.sign(from_cross));
            for (const auto& to : vertices) {
                const auto to_cross = kernel.cross(corner, to, before);
                trace.clip_sign(PL4, to, to_cross, kernel.sign(to_cross));
                if (run.set.opposite(kernel, from_cross, to_cross)) {
                    clipped.push_back(kernel.meet(from, to, from_cross, to_cross));
                    trace.clip_cross(PL5, clipped.back());
                }
                if (kernel.sign(to_cross) != Sign::positive) {
                    clipped.push_back(to);
                    trace.clip_keep(PL6, to);
                } else {
                    trace.clip_drop(PL6, to);
                }
                from = to;
                from_cross = to_cross;
            }
            vertices = std::move(clipped);
            trace.clip_list(PL7, vertices);
            if (vertices.empty()) break;
        }
        return vertices;
    }
};

}  // namespace vidno
