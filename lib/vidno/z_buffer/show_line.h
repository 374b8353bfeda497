/// ShowLine: the pixels of one scanline between two active edges, each painted if it is nearer than the stored depth.
///
/// Takes   a row, the two ends (active edges, or the vertices of a level one), and the polygon.
/// Gives   picture and depths changed at the pixel centres from the left end to the right, both included.
///         Without a visitor the picture may change only after the last line (ColorsFollow).
/// Time    one addition and one comparison for each pixel; under rounding the depth drifts with every step.
#pragma once

#include <type_traits>
#include <vector>

#include "../run.h"

namespace vidno {

/// A run without a visitor whose kernel compares many pixels at a time and keeps the polygon that each shows. The
/// pixels get their colours after the last line.
template <class Run>
concept ColorsFollow = std::is_same_v<decltype(Run::trace), NoTrace> && requires(Run& run) {
    run.set.shows(run.kernel, run.polygons[0].plane, run.depth_buffer.row(0), 0, 0);
};

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
        if constexpr (ColorsFollow<Run>) {
            run.set.shows(kernel, polygon.plane, depths, x, end);  // L5 to L7
            run.colors_follow = true;
            return;
        }
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

    /// The colours of all pixels, if they were not painted line by line.
    template <class Run>
    static void color_pixels(Run& run) {
        if constexpr (ColorsFollow<Run>) {
            if (!run.colors_follow) return;
            std::vector<Color> colors(run.polygons.size() + 1, run.background);  // by the number of the plane
            for (const auto& polygon : run.polygons) colors[polygon.plane.number] = polygon.color;
            for (int row = run.area.y; row < run.area.bottom(); ++row) {
                const auto depths = run.depth_buffer.row(row);
                const auto pixels = run.picture.row(row);
                for (int x = run.area.x; x < run.area.right(); ++x) pixels[x] = colors[depths.number(x)];
            }
        }
    }
};

}  // namespace vidno
