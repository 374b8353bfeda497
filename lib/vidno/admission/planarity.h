/// Whether the vertices of a polygon lie in a plane: the rule in ../admission.h.
#pragma once

#include <glm/vec3.hpp>

#include "measures.h"

namespace vidno::admission {

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
    const Answer answer = [&] {
        const CGAL::Protect_FPU_rounding<true> upward;  // once, not in each operation, as Bounds does
        return planar<CGAL::Interval_nt_advanced>(vertices);
    }();
    return (answer.is_certain() ? answer : planar<Exact>(vertices)).make_certain();
}

}  // namespace vidno::admission
