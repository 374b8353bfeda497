/// RationalPolygon: a polygon of a scene in exact arithmetic, with the answers of the picture rule about it.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "vidno/kernels/exact.h"
#include "vidno/scene.h"
#include "vidno/warnock/initialize_polygon.h"

namespace vidno {

struct InRationals {
    using Number = Rational;
    using Vertices = std::vector<Vertex<Rational>>;
};

inline Box<double> box_of(const ScenePolygon& polygon) {
    const auto& first = polygon.vertices.front();
    Box<double> box{first.x, first.y, first.x, first.y};
    for (const auto& v : polygon.vertices) {
        box = {std::min(box.xmin, v.x), std::min(box.ymin, v.y), std::max(box.xmax, v.x), std::max(box.ymax, v.y)};
    }
    return box;
}

struct RationalPolygon {
    InRationals::Vertices vertices;
    Plane<Rational> plane;  // c is 0 for an edge-on polygon, and has the sign of the inside
    Box<double> box;

    explicit RationalPolygon(const ScenePolygon& given) : plane{}, box(box_of(given)) {
        for (const auto& v : given.vertices) vertices.push_back({v.x, v.y, v.z});
        InRationals numbers;
        plane = InitializePolygon::initialize_polygon(numbers, vertices);
    }

    bool is_edge_on() const { return plane.c == 0; }

    /// The cross product that the procedures compute for an edge, named by its first vertex, and a point.
    Rational cross(std::size_t edge, const Point<Rational>& at) const {
        const auto &p = vertices[edge], &q = vertices[(edge + 1) % vertices.size()];
        return (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x);
    }
    /// Positive on the inner side of the edge.
    Rational inward(std::size_t edge, const Point<Rational>& at) const {
        return plane.c > 0 ? cross(edge, at) : Rational(-cross(edge, at));
    }
    /// Whether the point lies in the polygon or on its outline.
    bool holds(const Point<Rational>& at) const {
        for (std::size_t edge = 0; edge < vertices.size(); ++edge) {
            if (inward(edge, at) < 0) return false;
        }
        return !is_edge_on();
    }
    /// Of its plane, unless it is edge-on.
    Rational depth(const Point<Rational>& at) const { return -(plane.a * at.x + plane.b * at.y + plane.d) / plane.c; }
};

/// The polygons of a scene, which outlives them. Few are asked about, so each is converted when it is needed first.
class RationalPolygons {
public:
    explicit RationalPolygons(const Scene& scene) : scene_(&scene), converted_(scene.polygons.size()) {}

    int count() const { return int(converted_.size()); }
    Box<double> box(int place) const { return box_of(scene_->polygons[std::size_t(place)]); }
    const RationalPolygon& at(int place) {
        auto& polygon = converted_[std::size_t(place)];
        if (!polygon) polygon = std::make_unique<RationalPolygon>(scene_->polygons[std::size_t(place)]);
        return *polygon;
    }

private:
    const Scene* scene_;
    std::vector<std::unique_ptr<const RationalPolygon>> converted_;
};

inline Point<Rational> centre_of_pixel(int x, int y) { return {Rational(x + 0.5), Rational(y + 0.5)}; }

}  // namespace vidno
