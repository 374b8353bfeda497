/// Polygon: a polygon of the scene in the numbers of a kernel, as the procedures see it.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "kernel.h"

namespace vidno {

/// An edge of an edge-on polygon, and a plane through it that gives its depths (family/edge_depth.h).
template <Kernel K>
struct DepthEdge {
    std::vector<Vertex<typename K::Coordinate>> corners;  // of the plane
    typename K::Plane plane;
};

template <Kernel K>
struct Polygon {
    using Coordinate = typename K::Coordinate;

    int index = 0;  // its place in the scene
    Color color;
    bool edge_on = false;
    std::vector<Vertex<Coordinate>> vertices;
    Box<Coordinate> box;
    typename K::Plane plane;
    std::vector<DepthEdge<K>> edges;  // where edge-on polygons show, theirs
};

/// The least box around at least one vertex.
template <class Number>
Box<Number> box_around(const std::vector<Vertex<Number>>& vertices) {
    const auto less_x = [](const auto& v, const auto& w) { return select_lesser(v.x, w.x); };
    const auto less_y = [](const auto& v, const auto& w) { return select_lesser(v.y, w.y); };
    const auto [left, right] = std::minmax_element(vertices.begin(), vertices.end(), less_x);
    const auto [top, bottom] = std::minmax_element(vertices.begin(), vertices.end(), less_y);
    return {left->x, top->y, right->x, bottom->y};
}

/// The polygon at this index of the scene, where the set puts it on the screen. It has no plane yet.
template <class OnScreen>
OnScreen polygon_on_screen(const auto& set, const auto& kernel, const Area& area, const ScenePolygon& source,
                           int index) {
    OnScreen polygon;
    polygon.index = index;
    polygon.color = source.color;
    polygon.edge_on = source.edge_on;
    polygon.vertices.reserve(source.vertices.size());
    for (const auto& vertex : source.vertices) polygon.vertices.push_back(set.on_screen(kernel, area, vertex));
    polygon.box = box_around(polygon.vertices);
    return polygon;
}

/// The window's corners in the order of Corner.
template <Kernel K>
std::array<Point<typename K::Coordinate>, 4> corners_of(const K& kernel, const Window& window) {
    return {kernel.point(window.x, window.y), kernel.point(window.x, window.bottom()),
            kernel.point(window.right(), window.y), kernel.point(window.right(), window.bottom())};
}

}  // namespace vidno
