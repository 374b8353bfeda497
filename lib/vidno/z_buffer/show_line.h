/// ShowLine: the pixels of one scanline between two active edges, each painted if it is nearer than the stored depth.
///
/// Takes   a row, the two ends (active edges, or the vertices of a level one), and the polygon.
/// Gives   picture and depths changed at the pixel centres from the left end to the right, both included.
/// Time    one addition and one comparison for each pixel; under rounding the depth drifts with every step.
#pragma once

#include "../run.h"

namespace vidno {

struct ShowLine {
    template <class Run>
    static void show_line(Run& run, int row, const auto& left, const auto& right,
                          const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        using Interpolated = typename Run::Interpolated;
        auto& kernel = run.kernel;
        auto& trace = run.trace;
        trace.line(L1, row, left, right);

        auto [x, end] = run.set.columns_shown(run, row, left, right, polygon);
        if (run.set.misses(x, end)) {
            trace.miss(L2);
            return;
        }
        const bool is_point = kernel.same_place(left, right, row);
        const Interpolated dz = is_point ? run.set.slope_of_point(kernel, left, right)
                                         : Interpolated((right.z - left.z) / (right.x - left.x));
        trace.slope(L3, dz);
        const auto first_z = Interpolated(left.z + (run.set.start_of(run, left, x) - left.x) * dz);
        auto z = kernel.to_step(first_z, polygon.plane, Pixel{x, row});
        trace.columns(L4, x, end, z);
        const auto depths = run.depth_buffer.row(row);
        const auto pixels = run.picture.row(row);
        const Color color = polygon.color;
        for (; x < end; ++x, z += dz) {
            auto&& stored = depths[x];
            const auto& depth = kernel.to_store(z);
            const bool nearer = run.set.shows(kernel, depth, stored, Pixel{x, row});
            trace.pixel(L6, x, row, depth, stored, nearer);
            if (!nearer) continue;
            stored = depth;
            pixels[x] = color;
        }
    }
};

}  // namespace vidno
