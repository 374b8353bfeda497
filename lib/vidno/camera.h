/// Camera: from the world to the screen: view, projection, clipping to the view volume, division, viewport.
///
/// The world is right-handed. In clip space the view volume is -w <= x, y, z <= w with w > 0; z = w at the near plane
/// and -w at the far one, so that the greater z is nearer, as everywhere in vidno.
///
/// Polygons are clipped by Sutherland and Hodgman's method against the six sides in turn, before the division, so that
/// no vertex behind the eye is divided. A new vertex gets the side's coordinate exactly; z is clamped to [-1, 1]
/// against rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "scene.h"
#include "viewport.h"

namespace vidno {

enum class Projection : unsigned char { perspective, orthographic };

struct Camera {
    glm::dvec3 eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0};
    Projection projection = Projection::perspective;
    double field_of_view = 45;  // perspective: the whole vertical angle, in degrees
    double height = 2;          // orthographic: of the view volume
    double near_distance = 0.1, far_distance = 100;
};

/// From the world to clip space, and from there, after the division, to the screen.
struct View {
    glm::dmat4 to_clip;
    glm::dmat4 to_screen;
};

namespace camera {

inline bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline bool finite(const glm::dvec4& v) { return finite(glm::dvec3(v)) && std::isfinite(v.w); }
inline bool finite(const glm::dmat4& m) { return finite(m[0]) && finite(m[1]) && finite(m[2]) && finite(m[3]); }

/// The unit vector in the direction of v, for any length that doubles allow; zero for zero.
inline glm::dvec3 direction_of(glm::dvec3 v) {
    const double longest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (longest == 0) return v;
    v = glm::dvec3(v.x / longest, v.y / longest, v.z / longest);
    return glm::normalize(v);
}

/// Greater z nearer: GLM has -1 at the near plane.
inline glm::dmat4 projection_matrix(const Camera& camera, double aspect) {
    glm::dmat4 matrix =
        camera.projection == Projection::perspective
            ? glm::perspectiveRH_NO(glm::radians(camera.field_of_view), aspect, camera.near_distance,
                                    camera.far_distance)
            : glm::orthoRH_NO(-camera.height * aspect / 2, camera.height * aspect / 2, -camera.height / 2,
                              camera.height / 2, camera.near_distance, camera.far_distance);
    for (int column = 0; column < 4; ++column) matrix[column].z = -matrix[column].z;
    return matrix;
}

inline glm::dmat4 view_matrix(const Camera& camera) {
    const glm::dvec3 ahead = direction_of(camera.target - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, direction_of(camera.up)));
    const glm::dvec3 above = glm::cross(right, ahead);
    glm::dmat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        matrix[axis] = glm::dvec4(right[axis], above[axis], -ahead[axis], 0);
    }
    matrix[3] = glm::dvec4(-glm::dot(right, camera.eye), -glm::dot(above, camera.eye), glm::dot(ahead, camera.eye), 1);
    return matrix;
}

}  // namespace camera

inline View view_of(const Camera& camera, const Area& area) {
    const double aspect = double(area.width) / double(area.height);
    return {camera::projection_matrix(camera, aspect) * camera::view_matrix(camera), viewport_matrix(area)};
}

/// Why a camera is invalid, if it is.
inline std::optional<std::string_view> defect_of(const Camera& camera, const Area& area) {
    using camera::direction_of, camera::finite;
    if (!finite(camera.eye) || !finite(camera.target) || !finite(camera.up)) return "not finite";
    if (camera.eye == camera.target) return "eye and target are one point";
    const glm::dvec3 side = glm::cross(direction_of(camera.target - camera.eye), direction_of(camera.up));
    if (!(glm::length(side) > 1e-12)) return "up does not point aside from the direction of view";
    if (camera.projection == Projection::perspective) {
        if (!(0 < camera.field_of_view && camera.field_of_view < 180)) return "fov is not between 0 and 180 degrees";
        if (!(camera.near_distance > 0)) return "near is not greater than 0";
    } else if (!(camera.height > 0)) {
        return "height is not greater than 0";
    }
    if (!(camera.near_distance < camera.far_distance)) return "near is not less than far";
    if (!finite(view_of(camera, area).to_clip)) return "out of the range of doubles";
    return std::nullopt;
}

/// A convex polygon in clip space cut down to the view volume; fewer than three vertices if nothing is left.
inline std::vector<glm::dvec4> clip_to_view_volume(std::vector<glm::dvec4> polygon) {
    for (const int axis : {0, 1, 2}) {
        for (const double side : {-1.0, 1.0}) {
            const auto inside_by = [&](const glm::dvec4& vertex) { return vertex.w - side * vertex[axis]; };
            std::vector<glm::dvec4> kept;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const glm::dvec4& p = polygon[i];
                const glm::dvec4& q = polygon[(i + 1) % polygon.size()];
                const double dp = inside_by(p), dq = inside_by(q);
                if (dp >= 0) kept.push_back(p);
                if ((dp >= 0) == (dq >= 0)) continue;
                // Always from inside to outside, so that polygons that share the edge get the same vertex.
                glm::dvec4 meet = dp >= 0 ? p + (dp / (dp - dq)) * (q - p) : q + (dq / (dq - dp)) * (p - q);
                meet[axis] = side * meet.w;
                kept.push_back(meet);
            }
            polygon = std::move(kept);
        }
    }
    return polygon;
}

/// The visible part of a convex polygon of the world, in screen space; empty if nothing is visible or doubles cannot
/// hold it.
inline std::vector<glm::dvec3> seen_by(const View& view, const std::vector<glm::dvec3>& world) {
    std::vector<glm::dvec4> clipped;
    for (const glm::dvec3& vertex : world) clipped.push_back(view.to_clip * glm::dvec4(vertex, 1));
    if (!std::all_of(clipped.begin(), clipped.end(), [](const auto& vertex) { return camera::finite(vertex); })) {
        return {};
    }
    clipped = clip_to_view_volume(std::move(clipped));
    std::vector<glm::dvec3> screen;
    for (const glm::dvec4& vertex : clipped) {
        glm::dvec3 place(view.to_screen * glm::dvec4(glm::dvec3(vertex) / vertex.w, 1));
        if (!(vertex.w > 0) || !camera::finite(place)) return {};
        place.z = std::clamp(place.z, -1.0, 1.0);
        screen.push_back(place + glm::dvec3(0.0));  // -0 becomes 0
    }
    return screen.size() < 3 ? std::vector<glm::dvec3>{} : screen;
}

}  // namespace vidno
