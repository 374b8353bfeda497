/// HidingPolygon: the surrounding polygon that hides all others in a window, if the depths at its corners show one.
///
/// Takes   a window, and the polygons that surround it, lie in it or intersect it, in the order of the scene.
/// Gives   a surrounding one whose plane is the nearest at all four corners, the first of equally near ones; or none.
///         This is sufficient, since planes are linear over the window. It is not necessary, since a plane may be
///         nearer outside its polygon. An edge-on polygon has no depth at the corners; if there is one, the result is
///         none.
/// Time    four depths a polygon.
#pragma once

#include "../run.h"

namespace vidno {

struct HidingPolygon {
    template <class Run>
    static const Polygon<typename Run::Arithmetic>* hiding_polygon(
        Run& run, const Window& window, const ActivePolygonList<typename Run::Arithmetic>& polygons) {
        using enum Line;
        auto& trace = run.trace;

        const auto corners = corners_of(run.kernel, window);
        std::array<typename Run::Depth, 4> nearest;
        nearest.fill(run.kernel.farthest());
        trace.corners(HP1, nearest[0]);
        const Polygon<typename Run::Arithmetic>* hiding = nullptr;

        for (const auto& [polygon, surrounding] : polygons) {
            if (polygon->edge_on) return nullptr;  // HP2
            std::array<typename Run::Depth, 4> z;
            for (int i = 0; i < 4; ++i) z[i] = run.depth(HP3, *polygon, corners[i]);
            int k = 0;
            std::array<bool, 4> nearer;
            for (int i = 0; i < 4; ++i) {
                nearer[i] = run.kernel.nearer(z[i], nearest[i], corners[i]);
                trace.compare_corner(HP4, *polygon, i, z[i], nearest[i], nearer[i]);
                if (!nearer[i]) continue;
                nearest[i] = z[i];
                ++k;
            }
            trace.nearer(HP4, *polygon, nearer, k);
            if (k > 0) {
                hiding = nullptr;
                trace.uncover(HP5, *polygon);
            }
            if (surrounding && k == 4) {
                hiding = polygon;
                trace.cover(HP6, *polygon);
            }
        }
        return hiding;
    }
};

}  // namespace vidno
