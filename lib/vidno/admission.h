/// Admission: does a scene satisfy what every procedure assumes? Decided exactly for the given doubles.
///
/// An admitted polygon is finite, has at least three vertices, and is planar. Seen from the viewer it is convex and
/// winds around once; repeated and collinear vertices are allowed. Edge-on polygons (collinear seen from the viewer)
/// are admitted whatever the order of their vertices, since they show nothing and always lie in a plane.
///
/// Planar      no vertex is farther than 2^-40 of the extent from the plane of Newell's sum about the first vertex
///             (warnock/initialize_polygon.h). Triangles always are.
/// Convex      the outline goes once around the convex hull of its vertices. No vertex is farther than 2^-40 of the
///             extent from the side of the hull that the outline follows there, and along a side it never goes back by
///             more than that. So neither the vertex at which an outline starts nor its direction matters.
/// Rounding    an outline that is convex by this rule alone is replaced by the corners of its hull. One that is exactly
///             convex stays as it is: all its turns have one sign, and the direction of its edges, either "to the right
///             or straight down" or the opposite, flips exactly twice. (Each winding flips it twice, and an edge that
///             runs back on itself forces a turn of the other sign.)
/// Extent      the longest side of the box around the polygon.
/// Arithmetic  CGAL's filtered orientation for the turns; for the distances intervals first, rationals where these
///             cannot decide. No coordinate overflows or underflows into a decision.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "admission/convexity.h"
#include "admission/planarity.h"
#include "admitted.h"
#include "scene.h"

namespace vidno {

namespace admission {

inline bool all_finite(const Vertices& vertices) {
    return std::all_of(vertices.begin(), vertices.end(), [](const glm::dvec3& vertex) {
        return std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z);
    });
}

inline bool is_edge_on(const Vertices& vertices) {
    const glm::dvec3& p = vertices.front();
    const auto elsewhere = [&](const glm::dvec3& vertex) { return !same_place(p, vertex); };
    const auto q = std::find_if(vertices.begin(), vertices.end(), elsewhere);
    return q == vertices.end() ||
           std::all_of(q + 1, vertices.end(), [&](const glm::dvec3& r) { return turn(p, *q, r) == 0; });
}

}  // namespace admission

/// Checks all but the range of depth; sets edge_on and drops vertices where only rounding keeps the outline from being
/// convex.
inline PolygonAdmission admit_shape(ScenePolygon& polygon) {
    auto& vertices = polygon.vertices;
    if (vertices.size() < 3) return {Admission::too_few_vertices};
    if (!admission::all_finite(vertices)) return {Admission::not_finite};
    polygon.edge_on = admission::is_edge_on(vertices);
    if (polygon.edge_on || vertices.size() == 3) return {};
    const PolygonAdmission convex = admission::make_convex(vertices);
    if (!admission::is_planar(vertices)) return {Admission::not_planar};
    return convex;
}

/// Checks a polygon in screen space, as admit_shape does.
inline PolygonAdmission admit_polygon(ScenePolygon& polygon) {
    const auto in_range = [](const glm::dvec3& vertex) { return -1 <= vertex.z && vertex.z <= 1; };
    const auto& vertices = polygon.vertices;
    if (admission::all_finite(vertices) && !std::all_of(vertices.begin(), vertices.end(), in_range)) {
        return {Admission::out_of_depth_range};
    }
    return admit_shape(polygon);
}

/// For `admit`: checks the area, the number of polygons, and each polygon.
inline void make_admissible(Scene& scene) {
    expect_admissible(scene.area);
    if (scene.polygons.size() > most_polygons) throw std::invalid_argument("the scene has more than 2^20 polygons");
    for (ScenePolygon& polygon : scene.polygons) {
        const Admission admission = admit_polygon(polygon).admission;
        if (admission != Admission::admitted) {
            throw std::invalid_argument("polygon \"" + polygon.id + "\": " + std::string(reason_of(admission)));
        }
    }
}

/// A fan of triangles about the first vertex, without those that the viewer sees edge-on. For outlines that are convex
/// and planar but for rounding. Ids, colour and face are those of the polygon.
inline std::vector<ScenePolygon> cut_into_triangles(const ScenePolygon& polygon) {
    std::vector<ScenePolygon> triangles;
    const auto& vertices = polygon.vertices;
    for (std::size_t i = 2; i < vertices.size(); ++i) {
        ScenePolygon triangle{polygon.id, polygon.color, {vertices[0], vertices[i - 1], vertices[i]}};
        triangle.face = face_of_parts(polygon);
        if (!admission::is_edge_on(triangle.vertices)) triangles.push_back(std::move(triangle));
    }
    return triangles;
}

}  // namespace vidno
