/// ConvexParts: a simple polygon of the plane cut into few convex ones, exactly.
///
/// Source  G. H. Meisters, Polygons have ears, American Mathematical Monthly 82 (1975), cuts into triangles; S. Hertel
///         and K. Mehlhorn, Fast triangulation of simple polygons, FCT 1983, leave out the diagonals that the parts do
///         not need to be convex.
/// Takes   vertices, whose z is ignored; the outline may touch itself, as where a hole is bridged.
/// Gives   convex outlines of indices, with the orientation of the outline; none if the outline crosses itself or has
///         no area. Two parts that meet share whole edges.
/// Time    quadratic for usual outlines, cubic at worst.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "vidno/admission.h"

namespace vidno {

using Triangle = std::array<std::size_t, 3>;
using Outline = std::vector<std::size_t>;

/// The largest outline that is tried. In practice, faces that are not convex have fewer corners.
inline constexpr std::size_t most_corners_to_clip = 512;

/// Do two edges cross in a point inside both, or run along each other in the same direction?
inline bool cross(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s) {
    using admission::direction, admission::turn;
    const int to_r = turn(p, q, r), to_s = turn(p, q, s);
    if (to_r != 0 || to_s != 0) return to_r * to_s < 0 && turn(r, s, p) * turn(r, s, q) < 0;
    const int way = direction(p, q);
    return way != 0 && direction(r, s) == way && direction(p, s) == way && direction(r, q) == way;
}

/// The first vertices of two edges that cross; none if no two do.
inline std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(const std::vector<glm::dvec3>& vertices) {
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 2; j < count; ++j) {
            if (cross(vertices[i], vertices[i + 1], vertices[j], vertices[(j + 1) % count])) return std::pair(i, j);
        }
    }
    return std::nullopt;
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

inline std::vector<Triangle> clip_ears(const std::vector<glm::dvec3>& vertices, int sign) {
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

/// The index of a vertex in an outline if the next one is `to`; none if the outline has no such edge.
inline std::optional<std::size_t> place_of_edge(const Outline& outline, std::size_t from, std::size_t to) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if (outline[i] == from && outline[(i + 1) % outline.size()] == to) return i;
    }
    return std::nullopt;
}

/// Two parts joined along their common edge, which begins at these indices in them; nothing if the joined outline is
/// not convex.
inline std::optional<Outline> joined_along(const std::vector<glm::dvec3>& vertices, Outline one, std::size_t at,
                                           Outline other, std::size_t other_at, int sign) {
    std::rotate(one.begin(), one.begin() + std::ptrdiff_t(at) + 1, one.end());  // the common edge comes last
    std::rotate(other.begin(), other.begin() + std::ptrdiff_t(other_at) + 1, other.end());
    const auto turns_back = [&](std::size_t before, std::size_t corner, std::size_t after) {
        return admission::turn(vertices[before], vertices[corner], vertices[after]) == -sign;
    };
    if (turns_back(*(one.end() - 2), one.back(), other[1]) || turns_back(*(other.end() - 2), one.front(), one[1])) {
        return std::nullopt;
    }
    one.insert(one.end(), other.begin() + 1, other.end() - 1);
    return one;
}

/// The triangles, joined as long as the parts stay convex.
inline std::vector<Outline> joined_parts(const std::vector<glm::dvec3>& vertices,
                                         const std::vector<Triangle>& triangles, int sign) {
    std::vector<Outline> parts;
    for (const auto& [i, j, k] : triangles) parts.push_back({i, j, k});
    for (const Triangle& triangle : triangles) {
        for (std::size_t side = 0; side < 3; ++side) {
            const std::size_t from = triangle[side], to = triangle[(side + 1) % 3];
            const auto part_with = [&](std::size_t a, std::size_t b) {
                return std::find_if(parts.begin(), parts.end(),
                                    [&](const Outline& part) { return place_of_edge(part, a, b).has_value(); });
            };
            const auto one = part_with(from, to), other = part_with(to, from);
            if (one == parts.end() || other == parts.end() || one == other) continue;
            auto joined = joined_along(vertices, *one, *place_of_edge(*one, from, to), *other,
                                       *place_of_edge(*other, to, from), sign);
            if (!joined) continue;
            *one = std::move(*joined);
            parts.erase(other);
        }
    }
    return parts;
}

/// Whether a point is on the segment between two others and is neither of them.
inline bool is_inside(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) {
    if (admission::turn(from, to, point) != 0) return false;
    const int way = admission::direction(from, to);
    return !admission::same_place(point, from) && !admission::same_place(point, to) &&
           admission::direction(from, point) == way && admission::direction(point, to) == way;
}

/// The part with the vertices that lie inside its edges, which clipping left out and other parts may have as corners.
inline Outline with_vertices_on_edges(const std::vector<glm::dvec3>& vertices, const Outline& part) {
    Outline whole;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const glm::dvec3 &from = vertices[part[i]], &to = vertices[part[(i + 1) % part.size()]];
        Outline inside;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            if (is_inside(vertices[k], from, to)) inside.push_back(k);
        }
        std::sort(inside.begin(), inside.end(), [&](std::size_t a, std::size_t b) {
            return admission::direction(vertices[a], vertices[b]) == admission::direction(from, to);
        });
        whole.push_back(part[i]);
        whole.insert(whole.end(), inside.begin(), inside.end());
    }
    const auto same = [&](std::size_t a, std::size_t b) { return admission::same_place(vertices[a], vertices[b]); };
    whole.erase(std::unique(whole.begin(), whole.end(), same), whole.end());
    return whole;
}

inline std::vector<Outline> convex_parts(const std::vector<glm::dvec3>& vertices) {
    if (vertices.size() > most_corners_to_clip || crossing_edges(vertices)) return {};
    const int sign = CGAL::sign(admission::normal_of<admission::Exact>(vertices).z);
    std::vector<Outline> parts = joined_parts(vertices, clip_ears(vertices, sign), sign);
    for (Outline& part : parts) part = with_vertices_on_edges(vertices, part);
    return parts;
}

}  // namespace vidno
