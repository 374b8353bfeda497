/// Look: from polygons of the world to admitted polygons of a scene.
///
/// In the world there is no viewer yet, so a polygon is checked as seen along the axis nearest to its normal. Its image
/// under the camera is checked again. If rounding has left it off-plane or reflex beyond the tolerance, it is cut into
/// triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "admission.h"
#include "camera.h"
#include "scene.h"

namespace vidno {

/// The vertices with the coordinates permuted: the one along the axis becomes z. Turns keep their sign.
inline std::vector<glm::dvec3> seen_along(int axis, std::vector<glm::dvec3> vertices) {
    for (auto& vertex : vertices) vertex = {vertex[(axis + 1) % 3], vertex[(axis + 2) % 3], vertex[axis]};
    return vertices;
}

/// Newell's sum in doubles, of the polygon scaled so that nothing overflows: good for choices, not for decisions.
inline glm::dvec3 rough_normal(std::vector<glm::dvec3> vertices) {
    double greatest = 0;
    for (const auto& vertex : vertices) {
        for (int axis = 0; axis < 3; ++axis) greatest = std::max(greatest, std::abs(vertex[axis]));
    }
    if (greatest == 0) return {0, 0, 0};
    for (auto& vertex : vertices) vertex = {vertex.x / greatest, vertex.y / greatest, vertex.z / greatest};
    const auto normal = admission::normal_of<double>(vertices);
    return {normal.x, normal.y, normal.z};
}

/// The best axis along which the polygon has an area, decided exactly; -1 if it has none along any axis.
inline int axis_that_shows(const std::vector<glm::dvec3>& vertices) {
    const glm::dvec3 normal = rough_normal(vertices);
    std::array<int, 3> axes{2, 0, 1};
    std::stable_sort(axes.begin(), axes.end(), [&](int i, int j) { return std::abs(normal[i]) > std::abs(normal[j]); });
    for (const int axis : axes) {
        if (!admission::is_edge_on(seen_along(axis, vertices))) return axis;
    }
    return -1;
}

/// Checks a finite polygon of the world. edge_on means here that it has no area from anywhere.
inline PolygonAdmission admit_in_world(ScenePolygon& polygon) {
    if (polygon.vertices.size() < 3) return {Admission::too_few_vertices};
    if (!admission::all_finite(polygon.vertices)) return {Admission::not_finite};
    const int axis = axis_that_shows(polygon.vertices);
    polygon.edge_on = axis < 0;
    if (polygon.edge_on || polygon.vertices.size() == 3) return {};
    ScenePolygon along{polygon.id, polygon.color, seen_along(axis, polygon.vertices)};
    const PolygonAdmission admitted = admit_shape(along);
    const int back = (4 - axis) % 3;  // shifts by axis + 1 and by back + 1 places add up to whole rounds
    polygon.vertices = seen_along(back, std::move(along.vertices));
    return admitted;
}

/// The admitted polygons that a view shows of a convex planar polygon of the world.
inline Seen look(const View& view, const ScenePolygon& world) {
    ScenePolygon polygon{world.id, world.color, seen_by(view, world.vertices), false, world.face};
    if (polygon.vertices.empty()) return {};
    const PolygonAdmission admitted = admit_polygon(polygon);
    if (admitted.admission == Admission::admitted) return {{std::move(polygon)}, admitted.dropped};
    return {cut_into_triangles(polygon)};
}

}  // namespace vidno
