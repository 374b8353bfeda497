/// Closed convex bodies for tests, with faces counter-clockwise as seen from outside.
#pragma once

#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "scenes.h"

namespace vidno::test {

using Faces = std::vector<Corners>;

/// The faces of the parallelepiped with a corner o and edges u, v and w. If these are short binary fractions, their
/// sums are exact and the faces are planar.
inline Faces parallelepiped(const glm::dvec3& o, glm::dvec3 u, glm::dvec3 v, const glm::dvec3& w) {
    if (glm::dot(glm::cross(u, v), w) > 0) std::swap(u, v);  // y grows downward
    const auto face = [](const glm::dvec3& at, const glm::dvec3& a, const glm::dvec3& b) {
        return Corners{at, at + a, at + a + b, at + b};
    };
    return {face(o, v, u), face(o, w, v), face(o, u, w), face(o + w, u, v), face(o + u, v, w), face(o + v, w, u)};
}

inline Faces tetrahedron(const glm::dvec3& a, glm::dvec3 b, glm::dvec3 c, const glm::dvec3& d) {
    if (glm::dot(glm::cross(b - a, c - a), d - a) > 0) std::swap(b, c);
    return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

inline SceneBuilder& add_body(SceneBuilder& builder, const Faces& faces) {
    for (const auto& face : faces) builder.polygon(face);
    return builder;
}

/// Bodies on a grid of half pixels, so their outlines often pass through pixel centres.
struct RandomBodies : RandomScenes {
    explicit RandomBodies(unsigned seed) : RandomScenes(seed) {}

    glm::dvec3 place(const Area& area) {
        return {area.x + whole(-4, 2 * area.width + 4) / 2.0, area.y + whole(-4, 2 * area.height + 4) / 2.0,
                whole(-4, 4) / 16.0};
    }
    glm::dvec3 way() { return {whole(-8, 8) / 2.0, whole(-8, 8) / 2.0, whole(-4, 4) / 16.0}; }

    Faces body(const Area& area) {
        if (whole(0, 1) == 0) return tetrahedron(place(area), place(area), place(area), place(area));
        return parallelepiped(place(area), way(), way(), way());
    }

    AdmittedScene scene() {
        const Area drawing = area();
        SceneBuilder builder(drawing);
        for (int i = whole(1, 3); i > 0; --i) add_body(builder, body(drawing));
        return builder.build();
    }
};

}  // namespace vidno::test
