/// ShowLine: the pixels of one scanline between two active edges, each painted if it is nearer than the stored depth.
///
/// Takes   a row, the two ends (active edges, or the vertices of a level one), and the polygon.
/// Gives   picture and depths changed at the pixel centres from the left end to the right, both included.
/// Time    one addition and one comparison for each pixel; under rounding the depth drifts with every step.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>

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
        constexpr bool is_heard = !std::is_same_v<decltype(run.trace), NoTrace>;
        if constexpr (!is_heard) x = show_blocks(run, z, depths, pixels, x, end, color);
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

private:
    /// L5 to L7 for whole blocks of pixels, if the kernel compares a block at a time. Returns the first pixel after them, to which z is
    /// stepped.
    template <class Run>
    static int show_blocks(Run& run, auto& z, const auto& depths, const auto& pixels, int x, int end, Color color) {
        if constexpr (requires { run.set.shows(run.kernel, z, depths, x); }) {
            constexpr int block = Run::Arithmetic::block;
            std::array<Color, block> colors;
            colors.fill(color);
            for (; end - x >= block; x += block) {
                const std::optional<bool> nearer = run.set.shows(run.kernel, z, depths, x);
                if (!nearer) {
                    for (int i = x; i < x + block; ++i, z.skip(1)) {
                        if (!run.set.shows(run.kernel, z, depths[i], Pixel{i, depths.y})) continue;
                        depths[i] = z;
                        pixels[i] = color;
                    }
                    continue;
                }
                if (*nearer) {
                    depths.store_block(z, x);
                    std::copy_n(colors.begin(), block, &pixels[x]);
                }
                z.skip(block);
            }
        }
        return x;
    }
};

}  // namespace vidno
