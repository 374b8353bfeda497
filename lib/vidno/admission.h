/// Admission: does a scene satisfy what every procedure assumes? Decided exactly for the given doubles.
///
/// An admitted polygon is finite, has at least three vertices, and is planar. Seen from the viewer it is convex and
/// winds around once; repeated and collinear vertices are allowed. Edge-on polygons (collinear seen from the viewer) are
/// admitted whatever the order of their vertices, since they show nothing and always lie in a plane.
///
/// Planar      no vertex is farther than 2^-40 of the extent from the plane of Newell's sum about the first vertex
///             (warnock/initialize_polygon.h). Triangles always are.
/// Convex      all turns have one sign, and the direction of the edges, either "to the right or straight down" or the
///             opposite, flips exactly twice. This suffices: an outline that winds around once with turns of one sign is
///             convex, each winding flips the direction twice, and an edge that runs back on itself forces a turn of the
///             other sign.
/// Rounding    a vertex that is reflex by at most 2^-40 of the extent is dropped. The measure is its distance from the chord
///             that replaces it. Linear time.
/// Extent      the longest side of the box around the polygon.
/// Arithmetic  CGAL's filtered orientation for the turns; for the distances intervals first, rationals where these
///             cannot decide. No coordinate overflows or underflows into a decision.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "admitted.h"
#include "scene.h"

namespace vidno {

namespace admission {

using Vertices = std::vector<glm::dvec3>;
using Exact = CGAL::Exact_rational;
using Bounds = CGAL::Interval_nt<>;
using Answer = CGAL::Uncertain<bool>;  // certain for exact numbers; intervals may have to leave it open

inline int turn(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
    return CGAL::orientation(Point(p.x, p.y), Point(q.x, q.y), Point(r.x, r.y));
}

inline bool same_place(const glm::dvec3& p, const glm::dvec3& q) { return p.x == q.x && p.y == q.y; }

/// 1 to the right or straight down, -1 to the left or straight up, 0 if the viewer sees both points at one place.
inline int direction(const glm::dvec3& p, const glm::dvec3& q) {
    if (p.x != q.x) return p.x < q.x ? 1 : -1;
    if (p.y != q.y) return p.y < q.y ? 1 : -1;
    return 0;
}

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

/// The indices of the vertices, without those at the same place as the vertex before.
inline std::vector<std::size_t> without_repeats(const Vertices& vertices) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (kept.empty() || !same_place(vertices[kept.back()], vertices[i])) kept.push_back(i);
    }
    while (kept.size() > 1 && same_place(vertices[kept.front()], vertices[kept.back()])) kept.pop_back();
    return kept;
}

/// Turns of one sign and exactly two flips. `outline` holds indices of vertices at different places.
inline bool is_convex(const Vertices& vertices, const std::vector<std::size_t>& outline) {
    int first_turn = 0;
    int flips = 0;
    const std::size_t count = outline.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& p = vertices[outline[i]];
        const glm::dvec3& q = vertices[outline[(i + 1) % count]];
        const glm::dvec3& r = vertices[outline[(i + 2) % count]];
        flips += direction(p, q) != direction(q, r);
        const int sign = turn(p, q, r);
        if (sign == 0) continue;
        if (first_turn == 0) first_turn = sign;
        if (sign != first_turn) return false;
    }
    return first_turn != 0 && flips == 2;
}

template <class Number>
struct Vector {
    Number x, y, z;
};

template <class Number>
Vector<Number> difference(const glm::dvec3& p, const glm::dvec3& q) {
    return {Number(p.x) - Number(q.x), Number(p.y) - Number(q.y), Number(p.z) - Number(q.z)};
}

template <class Number>
Number squared(const Number& value) {
    return value * value;
}

template <class Number>
struct Box3 {
    Number width, height, depth;
};

template <class Number>
Box3<Number> box_of(const Vertices& vertices) {
    glm::dvec3 low = vertices.front(), high = vertices.front();
    for (const glm::dvec3& vertex : vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    const Vector<Number> side = difference<Number>(high, low);
    return {side.x, side.y, side.z};
}

/// Is numerator / denominator, a squared distance, at most the square of 2^-40 of the box's longest side?
template <class Number>
Answer within_tolerance(const Number& numerator, const Number& denominator, const Box3<Number>& box) {
    const Number share = Number(0x1p-80) * denominator;
    const Answer by_width = numerator <= share * squared(box.width);
    const Answer by_height = numerator <= share * squared(box.height);
    const Answer by_depth = numerator <= share * squared(box.depth);
    return by_width | by_height | by_depth;
}

/// Newell's sum about the first vertex: the normal of the plane.
template <class Number>
Vector<Number> normal_of(const Vertices& vertices) {
    Vector<Number> sum{Number(0), Number(0), Number(0)};
    Vector<Number> p = sum;
    for (std::size_t i = 1; i <= vertices.size(); ++i) {
        const Vector<Number> q = difference<Number>(vertices[i % vertices.size()], vertices.front());
        sum.x += (p.y - q.y) * (p.z + q.z);
        sum.y += (p.z - q.z) * (p.x + q.x);
        sum.z += (p.x - q.x) * (p.y + q.y);
        p = q;
    }
    return sum;
}

template <class Number>
Answer planar(const Vertices& vertices) {
    const Vector<Number> normal = normal_of<Number>(vertices);
    const Number squared_normal = squared(normal.x) + squared(normal.y) + squared(normal.z);
    const Box3<Number> box = box_of<Number>(vertices);
    Answer answer = true;
    for (const glm::dvec3& vertex : vertices) {
        const Vector<Number> way = difference<Number>(vertex, vertices.front());
        const Number height = normal.x * way.x + normal.y * way.y + normal.z * way.z;
        answer = answer & within_tolerance(squared(height), squared_normal, box);
    }
    return answer;
}

inline bool is_planar(const Vertices& vertices) {
    if (vertices.size() == 3) return true;
    const Answer answer = planar<Bounds>(vertices);
    return (answer.is_certain() ? answer : planar<Exact>(vertices)).make_certain();
}

/// Seen from the viewer, is q within the tolerance of the segment from p to r?
inline bool near_chord(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const Box3<Exact>& box) {
    const Vector<Exact> chord = difference<Exact>(r, p);
    const Vector<Exact> way = difference<Exact>(q, p);
    const Exact squared_chord = squared(chord.x) + squared(chord.y);
    const Exact along = way.x * chord.x + way.y * chord.y;
    if (along <= 0) return within_tolerance<Exact>(squared(way.x) + squared(way.y), 1, box).make_certain();
    if (along >= squared_chord) {
        const Vector<Exact> beyond = difference<Exact>(q, r);
        return within_tolerance<Exact>(squared(beyond.x) + squared(beyond.y), 1, box).make_certain();
    }
    return within_tolerance<Exact>(squared(Exact(chord.x * way.y - chord.y * way.x)), squared_chord, box)
        .make_certain();
}

/// The outline without its reflex vertices: one walk with a stack, from a vertex that surely stays. It also drops vertices
/// at which an edge runs back on itself.
inline std::vector<std::size_t> without_reflex(const Vertices& vertices, std::vector<std::size_t> outline, int sign) {
    const auto before = [&](std::size_t i, std::size_t j) { return direction(vertices[i], vertices[j]) > 0; };
    std::rotate(outline.begin(), std::min_element(outline.begin(), outline.end(), before), outline.end());
    std::vector<std::size_t> kept;
    const auto last_is_reflex = [&](const glm::dvec3& next) {
        const glm::dvec3& p = vertices[kept.end()[-2]];
        const glm::dvec3& q = vertices[kept.back()];
        const int side = turn(p, q, next);
        return side == -sign || (side == 0 && direction(p, q) == -direction(q, next));
    };
    const auto drop_reflex = [&](const glm::dvec3& next) {
        while (kept.size() >= 2 && last_is_reflex(next)) kept.pop_back();
    };
    for (const std::size_t i : outline) {
        drop_reflex(vertices[i]);
        if (kept.empty() || !same_place(vertices[kept.back()], vertices[i])) kept.push_back(i);
    }
    drop_reflex(vertices[outline.front()]);
    std::sort(kept.begin(), kept.end());
    return kept;
}

/// Is every dropped vertex of the outline within the tolerance of the chord that replaces it?
inline bool dropped_are_near(const Vertices& vertices, const std::vector<std::size_t>& outline,
                             const std::vector<std::size_t>& kept) {
    const Box3<Exact> box = box_of<Exact>(vertices);
    std::size_t next = 0;  // in kept: the first that is not before the vertex
    return std::all_of(outline.begin(), outline.end(), [&](std::size_t i) {
        if (next < kept.size() && kept[next] == i) return ++next, true;
        const std::size_t previous = (next + kept.size() - 1) % kept.size();
        return near_chord(vertices[kept[previous]], vertices[i], vertices[kept[next % kept.size()]], box);
    });
}

/// Checks that the outline is convex, dropping vertices that are reflex by rounding. Reports how many it dropped.
inline PolygonAdmission make_convex(Vertices& vertices) {
    const std::vector<std::size_t> outline = without_repeats(vertices);
    if (is_convex(vertices, outline)) return {};
    const int sign = CGAL::sign(normal_of<Exact>(vertices).z);
    if (sign == 0) return {Admission::not_convex};
    const std::vector<std::size_t> kept = without_reflex(vertices, outline, sign);
    if (!is_convex(vertices, kept) || !dropped_are_near(vertices, outline, kept)) return {Admission::not_convex};
    Vertices rest;
    for (const std::size_t i : kept) rest.push_back(vertices[i]);
    vertices = std::move(rest);
    return {Admission::admitted, outline.size() - kept.size()};
}

}  // namespace admission

/// Checks all but the range of depth; sets edge_on and drops vertices that are reflex by rounding.
inline PolygonAdmission admit_shape(ScenePolygon& polygon) {
    auto& vertices = polygon.vertices;
    if (vertices.size() < 3) return {Admission::too_few_vertices};
    if (!admission::all_finite(vertices)) return {Admission::not_finite};
    polygon.edge_on = admission::is_edge_on(vertices);
    if (polygon.edge_on || vertices.size() == 3) return {};
    const PolygonAdmission convex = admission::make_convex(vertices);
    if (convex.admission != Admission::admitted) return convex;
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
/// and planar but for rounding; ids and colour are those of the polygon.
inline std::vector<ScenePolygon> cut_into_triangles(const ScenePolygon& polygon) {
    std::vector<ScenePolygon> triangles;
    const auto& vertices = polygon.vertices;
    for (std::size_t i = 2; i < vertices.size(); ++i) {
        ScenePolygon triangle{polygon.id, polygon.color, {vertices[0], vertices[i - 1], vertices[i]}};
        if (!admission::is_edge_on(triangle.vertices)) triangles.push_back(std::move(triangle));
    }
    return triangles;
}

}  // namespace vidno
