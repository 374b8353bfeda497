/// Ear clipping: a simple polygon of the plane cut into triangles, exactly.
///
/// Source  G. H. Meisters, Polygons have ears, American Mathematical Monthly 82 (1975).
/// Takes   vertices, whose z is ignored; the outline may touch itself, as where a hole is bridged.
/// Gives   triangles of indices, with the orientation of the outline; none if the outline crosses itself or has no area.
/// Time    quadratic for usual outlines, cubic at worst.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "vidno/admission.h"

namespace vidno {

using Triangle = std::array<std::size_t, 3>;

/// The largest outline that is tried. In practice, faces that are not convex have fewer corners.
inline constexpr std::size_t most_corners_to_clip = 512;

/// Do two edges cross in a point inside both?
inline bool cross(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s) {
    using admission::turn;
    return turn(p, q, r) * turn(p, q, s) < 0 && turn(r, s, p) * turn(r, s, q) < 0;
}

inline bool crosses_itself(const std::vector<glm::dvec3>& vertices) {
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 2; j < count; ++j) {
            if (cross(vertices[i], vertices[i + 1], vertices[j], vertices[(j + 1) % count])) return true;
        }
    }
    return false;
}

/// May the corner be cut off? It must turn like the outline, with no other vertex in or on the triangle.
inline bool is_ear(const std::vector<glm::dvec3>& vertices, const std::vector<std::size_t>& outline,
                   const Triangle& corner, int sign) {
    using admission::same_place, admission::turn;
    const glm::dvec3 &p = vertices[corner[0]], &q = vertices[corner[1]], &r = vertices[corner[2]];
    if (turn(p, q, r) != sign) return false;
    for (const std::size_t i : outline) {
        const glm::dvec3& s = vertices[i];
        if (same_place(s, p) || same_place(s, q) || same_place(s, r)) continue;
        if (turn(p, q, s) != -sign && turn(q, r, s) != -sign && turn(r, p, s) != -sign) return false;
    }
    return true;
}

inline std::vector<Triangle> clip_ears(const std::vector<glm::dvec3>& vertices) {
    if (vertices.size() > most_corners_to_clip || crosses_itself(vertices)) return {};
    const int sign = CGAL::sign(admission::normal_of<admission::Exact>(vertices).z);
    std::vector<std::size_t> outline(vertices.size());
    for (std::size_t i = 0; i < outline.size(); ++i) outline[i] = i;

    std::vector<Triangle> triangles;
    std::size_t at = 0, tried = 0;
    while (outline.size() >= 3 && tried < outline.size()) {
        const std::size_t count = outline.size();
        at %= count;
        const Triangle corner{outline[(at + count - 1) % count], outline[at], outline[(at + 1) % count]};
        const bool flat = admission::turn(vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]) == 0;
        if (flat || is_ear(vertices, outline, corner, sign)) {
            if (!flat) triangles.push_back(corner);
            outline.erase(outline.begin() + std::ptrdiff_t(at));
            tried = 0;
        } else {
            ++at;
            ++tried;
        }
    }
    if (outline.size() >= 3) return {};  // no ear is left: the outline was not simple
    return triangles;
}

}  // namespace vidno
