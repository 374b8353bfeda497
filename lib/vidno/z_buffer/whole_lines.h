/// WholeLines: the Z-buffer without a visitor, for a kernel that compares the pixels of a line together.
///
/// Nobody sees the steps of such a run, so ShowLine is one call of the kernel, and no depth is stepped. The depth
/// buffer keeps the polygon that each pixel shows; the pixels get their colours at the end. The picture is the same.
#pragma once

#include <array>
#include <vector>

#include "../corrected.h"

namespace vidno {

template <class K>
concept ComparesLines = Kernel<K> &&
    requires(K& kernel, typename K::DepthBuffer& depths, const typename K::Plane& plane) {
    kernel.store_nearer(plane, depths.row(0), 0, 0);
};

struct WholeLines : Corrected {
    static constexpr auto methods = std::to_array({Method::zbuffer});

    static void z_buffer(auto& run) {
        Corrected::z_buffer(run);
        color_pixels(run);
    }

    static void show_line(auto& run, int row, const auto& left, const auto& right, const auto& polygon) {
        const auto [first, end] = columns_shown(run, row, left, right, polygon);
        if (first < end) run.kernel.store_nearer(polygon.plane, run.depth_buffer.row(row), first, end);
    }

private:
    static void color_pixels(auto& run) {
        std::vector<Color> colors(run.polygons.size() + 1, run.background);  // by the number of the plane
        for (const auto& polygon : run.polygons) colors[polygon.plane.number] = polygon.color;
        for (int row = run.area.y; row < run.area.bottom(); ++row) {
            const auto depths = run.depth_buffer.row(row);
            const auto pixels = run.picture.row(row);
            for (int x = run.area.x; x < run.area.right(); ++x) pixels[x] = colors[depths.number(x)];
        }
    }
};

}  // namespace vidno
