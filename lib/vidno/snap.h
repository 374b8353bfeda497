/// Snap: a scene on a grid of sub-pixels, as the kernel `grid` takes it and as hardware makes it.
///
/// A polygon with more than three vertices of which one moves is cut into a fan first, for snapped it would be neither
/// planar nor convex. x and y go to the nearest multiple of 2^-K pixel, z to the nearest of 2^-24; of two equally near
/// ones to that farther from 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

#include "admission.h"
#include "kernels/grid.h"
#include "scene.h"
#include "window.h"

namespace vidno {

/// What snapping did.
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

/// A grid: so many binary places.
struct Resolution {
    int xy;
    int z = grid_depth_bits;
};
inline constexpr int every_place = 1074;  // of any double: nothing moves

inline glm::dvec3 snapped(const glm::dvec3& vertex, Resolution to) {
    return {snapped(vertex.x, to.xy), snapped(vertex.y, to.xy), snapped(vertex.z, to.z)};
}

/// The polygon, or the triangles that it was cut into, all of its id.
inline std::vector<ScenePolygon> snapped(const ScenePolygon& polygon, Resolution to, Snapping& snapping) {
    const auto stays = [&](const glm::dvec3& vertex) { return vertex == snapped(vertex, to); };
    const bool whole =
        polygon.vertices.size() == 3 || std::all_of(polygon.vertices.begin(), polygon.vertices.end(), stays);
    snapping.cut += whole ? 0 : 1;
    std::vector<ScenePolygon> parts = whole ? std::vector{polygon} : cut_into_triangles(polygon);
    for (auto& part : parts) {
        for (auto& vertex : part.vertices) {
            const glm::dvec3 before = std::exchange(vertex, snapped(vertex, to));
            const glm::dvec3 way = glm::abs(vertex - before);
            ++snapping.vertices;
            snapping.moved += vertex == before ? 0 : 1;
            snapping.farthest_moved = std::max({snapping.farthest_moved, way.x, way.y});
            snapping.deepest_moved = std::max(snapping.deepest_moved, way.z);
        }
        const bool was_edge_on = std::exchange(part.edge_on, admission::is_edge_on(part.vertices));
        snapping.vanished += part.edge_on && !was_edge_on ? 1 : 0;
    }
    return parts;
}

/// Each polygon of the scene, or its triangles.
inline Scene snapped(Scene scene, Resolution to) {
    Snapping snapping;
    for (const auto& polygon : std::exchange(scene.polygons, {})) {
        for (auto& part : snapped(polygon, to, snapping)) scene.polygons.push_back(std::move(part));
    }
    return scene;
}

/// Is the scene, snapped, less than grid_width steps across? Wider ones the kernel's whole numbers do not hold.
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
