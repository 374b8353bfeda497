/// Resolution: a grid of sub-pixels, and numbers on it. snap.h snaps scenes to one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "kernels/grid.h"
#include "scene.h"
#include "window.h"

namespace vidno {

/// The changes that snapping made.
struct Snapping {
    std::size_t vertices = 0, moved = 0;  // of the polygons and triangles that it made
    double farthest_moved = 0;            // in x or y, in pixels
    double deepest_moved = 0;             // in z
    std::size_t cut = 0;                  // polygons, into triangles
    std::size_t vanished = 0;             // triangles left without area
};

/// The nearest multiple of 2^-bits.
inline double snapped(double value, int bits) {
    const double steps = std::ldexp(value, bits);
    if (!(std::abs(steps) < 0x1p52)) return value;  // whole already
    return std::ldexp(std::round(steps), -bits);
}

/// A grid, by the number of its binary places.
struct Resolution {
    int xy;
    int z = grid_depth_bits;
};
inline constexpr int every_place = 1074;  // of any double: nothing moves

inline glm::dvec3 snapped(const glm::dvec3& vertex, Resolution to) {
    return {snapped(vertex.x, to.xy), snapped(vertex.y, to.xy), snapped(vertex.z, to.z)};
}

/// Is the snapped scene less than grid_width steps across? The kernel's whole numbers do not hold wider ones.
inline bool fits_grid(const Scene& scene, int bits) {
    const Window square = covering_square(scene.area);
    glm::dvec2 low(square.x, square.y), high(square.right(), square.bottom());
    for (const auto& polygon : scene.polygons) {
        for (const auto& vertex : polygon.vertices) {
            low = glm::min(low, glm::dvec2(vertex));
            high = glm::max(high, glm::dvec2(vertex));
        }
    }
    const glm::dvec2 across = high - low;
    return std::ldexp(std::max(across.x, across.y), bits) + 1 < grid_width;
}

}  // namespace vidno
