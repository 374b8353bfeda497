/// Snap: a scene snapped to a grid of sub-pixels, as the kernel `grid` needs it and as hardware does it.
///
/// A polygon with more than three vertices, any of which moves, is first cut into a fan, since snapping may leave it
/// neither planar nor convex. x and y are rounded to the nearest multiple of 2^-K pixel, z to the nearest of 2^-24;
/// ties go away from 0.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "admission.h"
#include "resolution.h"

namespace vidno {

/// The polygon, or the triangles that it was cut into, all with its id.
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
inline AdmittedScene snapped(const AdmittedScene& scene, Resolution to) {
    Snapping snapping;
    Scene result{scene->name, scene->area, scene->background, {}};
    for (const auto& polygon : scene->polygons) {
        for (auto& part : snapped(polygon, to, snapping)) result.polygons.push_back(std::move(part));
    }
    return admit(std::move(result));
}

}  // namespace vidno
