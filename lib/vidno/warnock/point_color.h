/// PointColor: the colour of the nearest polygon at a point.
///
/// Takes   a point and the polygons that may contain it.
/// Gives   the colour of the first of the nearest ones; the background if no polygon contains the point.
#pragma once

#include "../run.h"

namespace vidno {

struct PointColor {
    template <class Run>
    static Color point_color(Run& run, const typename Run::Place& point,
                             const ActivePolygonList<typename Run::Arithmetic>& active_polygons) {
        using enum Line;
        auto& trace = run.trace;

        Color color = run.background;
        auto nearest = run.kernel.farthest();
        for (const auto& [polygon, surrounding] : active_polygons) {
            if (!run.surround_test(PC2, point, *polygon)) continue;
            const auto z = run.depth(PC3, *polygon, point);
            const bool nearer = run.kernel.nearer(z, nearest, point);
            trace.compare(PC4, *polygon, z, nearest, nearer);
            if (!nearer) continue;
            nearest = z;
            color = polygon->color;
            trace.nearest(PC4, *polygon, z);
        }
        return color;
    }
};

}  // namespace vidno
