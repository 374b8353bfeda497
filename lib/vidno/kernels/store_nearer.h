/// StoreNearer: the depth of a plane at pixels of a row, stored where it is nearer than what is there.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "pixel_block.h"
#include "plane_depth.h"

namespace vidno {

/// Stores the depth at the pixels first <= x < end. Since a depth is not a sum of steps, a block of pixels is compared
/// at once. Where two depths in cells differ by no more than `cell_error`, or one is not known, the cells do not
/// decide: `store_closely(first, end)` then stores the block pixel by pixel.
template <class Plane>
[[gnu::noinline]] void store_nearer_blocks(const Plane& plane, const auto& row, int first, int end, float cell_error,
                                           const auto& store_closely) {
    using Block = PixelBlock;
    using Floats = Block::Floats;
    using Ints = Block::Ints;
    constexpr int all_but_sign = std::numeric_limits<int>::max();

    const auto slope = float(plane.x_slope);
    const float first_z = plane.fits_cells ? float(plane.depth(first + 0.5, row.y + 0.5)) : depth_not_known;
    const Floats slopes{slope, slope, slope, slope};
    const Floats first_zs{first_z, first_z, first_z, first_z};
    Floats steps{0, 1, 2, 3};
    float* depths = row.about + (first - row.first_x);
    std::uint32_t* planes = row.plane + (first - row.first_x);
    for (int left = end - first; left > 0; left -= Block::pixels, depths += Block::pixels, planes += Block::pixels) {
        std::array<Floats, 2> z, stored;
        std::array<Ints, 2> nearer, close;
        for (int half = 0; half < 2; ++half) {
            stored[half] = Block::loaded<Floats>(depths + 4 * half);
            z[half] = steps * slopes + first_zs;
            steps += 4;
            const Floats difference = z[half] - stored[half];
            const Floats distance = std::bit_cast<Floats>(std::bit_cast<Ints>(difference) & all_but_sign);
            const Ints in_line = Ints{0, 1, 2, 3} + 4 * half < left;
            nearer[half] = (difference > cell_error) & in_line;
            close[half] = ~(distance > cell_error) & in_line;
        }
        if (!Block::any(nearer[0] | nearer[1] | close[0] | close[1])) continue;
        if (Block::any(close[0] | close[1])) [[unlikely]] {
            store_closely(end - left, std::min(end - left + Block::pixels, end));
            continue;
        }
        const Ints number = Ints{} + int(plane.number);
        for (int half = 0; half < 2; ++half) {
            Block::store_where(nearer[half], std::bit_cast<Ints>(z[half]), std::bit_cast<Ints>(stored[half]),
                               depths + 4 * half);
            Block::store_where(nearer[half], number, Block::loaded<Ints>(planes + 4 * half), planes + 4 * half);
        }
    }
}

}  // namespace vidno
