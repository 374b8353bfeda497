/// InitializePolygon: the plane a x + b y + c z + d = 0 of a polygon.
///
/// Source  M. E. Newell's sum over the edges (Sutherland, Sproull and Schumacker, Computing Surveys 6(1), 1974), with
///         coordinates relative to the first vertex. Unlike the determinants of the first three vertices it works when
///         these are collinear, and takes every vertex into account.
/// Takes   at least three vertices.
/// Gives   the plane through the first vertex; c is twice the area seen by the viewer, 0 for an edge-on polygon.
#pragma once

#include "../kernel.h"

namespace vidno {

struct InitializePolygon {
    template <class Run>
    static Plane<typename Run::Number> initialize_polygon(Run&, const typename Run::Vertices& vertices) {
        using Number = typename Run::Number;
        const auto& origin = vertices.front();
        Number a = 0, b = 0, c = 0;
        Vertex<Number> p{0, 0, 0};
        for (std::size_t i = 1; i <= vertices.size(); ++i) {
            const auto& vertex = vertices[i % vertices.size()];
            const Vertex<Number> q{vertex.x - origin.x, vertex.y - origin.y, vertex.z - origin.z};
            a += (p.y - q.y) * (p.z + q.z);
            b += (p.z - q.z) * (p.x + q.x);
            c += (p.x - q.x) * (p.y + q.y);
            p = q;
        }
        const Number d = -(a * origin.x + b * origin.y + c * origin.z);
        return {a, b, c, d};
    }
};

}  // namespace vidno
