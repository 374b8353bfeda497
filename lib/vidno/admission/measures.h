/// The arithmetic of admission: turns and directions of points on the screen, and distances as shares of a polygon's
/// extent. A function of numbers takes intervals first, and rationals where these cannot decide.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace vidno::admission {

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

}  // namespace vidno::admission
