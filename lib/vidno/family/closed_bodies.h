/// Closed convex bodies: does a scene consist of them? Decided exactly for the given doubles.
///
/// Polygons that share edges make a body. It is closed and convex if
///   - each edge belongs to two of its polygons, which traverse it in opposite directions;
///   - each polygon has an area, all of its vertices lie in its plane, and all other vertices of the body in it or
///     behind it.
/// The vertices of a polygon run counter-clockwise as seen from the front, as in a mesh. Since y grows downward, its
/// normal, Newell's sum, points backward, and a polygon with c < 0 faces the viewer.
///
/// Faces that look away may be removed: the polygons of a body cover its hull. Where a line of sight meets the hull,
/// the nearest point is on a closed face that looks towards the viewer, or a limit of such points and so on one too. A
/// face that looks away is never nearer. It may be equally near on the body's outline.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../admission.h"

namespace vidno {

namespace closed_bodies {

using Place = std::array<double, 3>;
using Edge = std::pair<Place, Place>;  // from, to

inline Place place_of(const glm::dvec3& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }  // -0 is 0

/// The polygon that traverses each directed edge, by its index in the scene, and the first polygon that repeats one.
struct Edges {
    std::map<Edge, std::size_t> polygons;
    std::optional<std::size_t> repeating;  // traverses an edge in a direction that was taken before
};

inline Edges edges_of(const std::vector<ScenePolygon>& polygons) {
    Edges edges;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const auto& vertices = polygons[i].vertices;
        for (std::size_t j = 0; j < vertices.size(); ++j) {
            const Place from = place_of(vertices[j]);
            const Place to = place_of(vertices[(j + 1) % vertices.size()]);
            if (from == to) continue;
            if (!edges.polygons.emplace(Edge{from, to}, i).second && !edges.repeating) edges.repeating = i;
        }
    }
    return edges;
}

/// The plane of a polygon, in intervals, and exactly where these do not decide.
class FacePlane {
public:
    explicit FacePlane(const std::vector<glm::dvec3>& vertices)
        : origin_(vertices.front()),
          near_(admission::normal_of<admission::Bounds>(vertices)),
          exact_(admission::normal_of<admission::Exact>(vertices)) {}

    bool is_none() const { return exact_.x == 0 && exact_.y == 0 && exact_.z == 0; }

    /// Positive where the normal points.
    CGAL::Sign side_of(const glm::dvec3& vertex) const {
        const auto side = CGAL::sign(height(near_, vertex));
        return side.is_certain() ? side.make_certain() : CGAL::sign(height(exact_, vertex));
    }

private:
    template <class Number>
    Number height(const admission::Vector<Number>& normal, const glm::dvec3& vertex) const {
        const auto way = admission::difference<Number>(vertex, origin_);
        return normal.x * way.x + normal.y * way.y + normal.z * way.z;
    }

    glm::dvec3 origin_;
    admission::Vector<admission::Bounds> near_;
    admission::Vector<admission::Exact> exact_;
};

/// Why a body, given by its polygons' places, is not convex.
inline std::optional<std::string> not_convex(const std::vector<ScenePolygon>& polygons,
                                             const std::vector<std::size_t>& body) {
    for (const std::size_t face : body) {
        const FacePlane plane(polygons[face].vertices);
        const std::string name = "polygon " + polygons[face].id;
        if (plane.is_none()) return name + " has no area";
        for (const std::size_t other : body) {
            for (const auto& vertex : polygons[other].vertices) {
                const CGAL::Sign side = plane.side_of(vertex);
                if (other == face && side != CGAL::ZERO) return name + " is not planar to the last digit";
                if (side == CGAL::NEGATIVE) {
                    return name + " has a vertex of polygon " + polygons[other].id +
                           " in front of it: its body is not convex, or its vertices are in the opposite order";
                }
            }
        }
    }
    return std::nullopt;
}

}  // namespace closed_bodies

/// Takes   an admitted scene.
/// Gives   why it does not consist of closed convex bodies, with the id of a polygon; nothing if it does.
/// Time    for each polygon, the vertices of its body.
inline std::optional<std::string> not_closed_convex_bodies(const Scene& scene) {
    using namespace closed_bodies;
    const auto& polygons = scene.polygons;
    const Edges edges = edges_of(polygons);
    if (edges.repeating) {
        return "polygon " + polygons[*edges.repeating].id +
               " goes along an edge in the same direction as another polygon";
    }
    std::vector<std::size_t> first_of_body(
        polygons.size());  // a polygon of the same body, up to the one that is its own
    std::iota(first_of_body.begin(), first_of_body.end(), std::size_t{0});
    const auto body_of = [&](std::size_t polygon) {
        while (first_of_body[polygon] != polygon)
            polygon = first_of_body[polygon] = first_of_body[first_of_body[polygon]];
        return polygon;
    };
    for (const auto& [edge, polygon] : edges.polygons) {
        const auto back = edges.polygons.find({edge.second, edge.first});
        if (back == edges.polygons.end() || back->second == polygon) {
            return "polygon " + polygons[polygon].id + " has an edge that no other polygon shares";
        }
        first_of_body[body_of(polygon)] = body_of(back->second);
    }
    std::map<std::size_t, std::vector<std::size_t>> bodies;
    for (std::size_t i = 0; i < polygons.size(); ++i) bodies[body_of(i)].push_back(i);
    for (const auto& [first, body] : bodies) {
        if (auto reason = not_convex(polygons, body)) return reason;
    }
    return std::nullopt;
}

}  // namespace vidno
