/// Admission: does a scene satisfy what every procedure assumes? Decided exactly for the given doubles.
///
/// An admitted polygon is finite, has at least three vertices, and is planar. Seen from the viewer it is convex and
/// winds around once; repeated and collinear vertices are allowed. Edge-on polygons (collinear seen from the viewer) are
/// admitted whatever the order of their vertices, since they show nothing and always lie in a plane.
///
/// Planar      no vertex is farther than 2^-40 of the extent from the plane of Newell's sum about the first vertex
///             (warnock/initialize_polygon.h). Triangles always are.
/// Convex      the outline goes once around the convex hull of its vertices. No vertex is farther than 2^-40 of the extent from
///             the side of the hull that the outline follows there, and along a side it never goes back by more than that.
///             So neither the vertex at which an outline starts nor its direction matters.
/// Rounding    an outline that is convex by this rule alone is replaced by the corners of its hull. One that is exactly convex
///             stays as it is: all its turns have one sign, and the direction of its edges, either "to the right or straight
///             down" or the opposite, flips exactly twice. (Each winding flips it twice, and an edge that runs back on
///             itself forces a turn of the other sign.)
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
#include <map>
#include <optional>
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
inline bool is_exactly_convex(const Vertices& vertices, const std::vector<std::size_t>& outline) {
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

/// Follows an outline around the convex hull of its vertices.
class HullWalk {
public:
    /// The outline holds indices of vertices at different places, in either direction. Seen from the viewer its area is not 0.
    HullWalk(const Vertices& vertices, std::vector<std::size_t> outline)
        : vertices_(vertices),
          outline_(std::move(outline)),
          box_(box_of<Exact>(vertices)),
          sign_(CGAL::sign(normal_of<Exact>(vertices).z)) {
        find_corners();
        if (sign_ < 0) std::reverse(corners_.begin(), corners_.end());
        std::rotate(corners_.begin(), std::min_element(corners_.begin(), corners_.end()), corners_.end());
    }

    /// Whether the outline is convex: the rule at the head of this file.
    bool is_once_around() const {
        if (sign_ == 0) return false;
        std::map<std::pair<double, double>, std::ptrdiff_t> number_at;
        for (std::size_t c = 0; c < corners_.size(); ++c) {
            const glm::dvec3& place = vertices_[corners_[c]];
            number_at[{place.x, place.y}] = std::ptrdiff_t(c);
        }
        std::vector<std::ptrdiff_t> passed;
        for (const std::size_t i : outline_) {
            const auto found = number_at.find({vertices_[i].x, vertices_[i].y});
            passed.push_back(found == number_at.end() ? none : found->second);
        }
        const auto is_corner = [](std::ptrdiff_t c) { return c != none; };
        const auto start = std::find_if(passed.begin(), passed.end(), is_corner) - passed.begin();
        std::ptrdiff_t advance = 0;
        auto last = std::size_t(start);
        for (std::size_t step = 1; step <= outline_.size(); ++step) {
            const std::size_t next = (std::size_t(start) + step) % outline_.size();
            if (!is_corner(passed[next])) continue;
            const auto ahead = corners_ahead(passed[last], passed[next]);
            if (!ahead || !follows_side(last, next)) return false;
            advance += *ahead;
            last = next;
        }
        return advance == std::ssize(corners_);
    }

    /// The vertices at the corners of the hull, in the direction of the outline and from its first.
    Vertices corners() const {
        Vertices places;
        for (const std::size_t i : corners_) places.push_back(vertices_[i]);
        return places;
    }

private:
    static constexpr std::ptrdiff_t none = -1;

    /// The monotone chain of Andrew: from the leftmost corner along the upper side of the screen and back along the lower one.
    void find_corners() {
        std::vector<std::size_t> sorted = outline_;
        std::sort(sorted.begin(), sorted.end(), [&](std::size_t i, std::size_t j) {
            const int way = direction(vertices_[i], vertices_[j]);
            return way != 0 ? way > 0 : i < j;
        });
        const auto same = [&](std::size_t i, std::size_t j) { return same_place(vertices_[i], vertices_[j]); };
        sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
        const auto add_chain = [&](auto first, auto last) {
            const std::size_t before = corners_.size();
            for (; first != last; ++first) {
                while (corners_.size() >= before + 2 &&
                       turn(vertices_[corners_.end()[-2]], vertices_[corners_.back()], vertices_[*first]) <= 0)
                    corners_.pop_back();
                corners_.push_back(*first);
            }
            corners_.pop_back();  // the first of the other chain
        };
        add_chain(sorted.begin(), sorted.end());
        add_chain(sorted.rbegin(), sorted.rend());
    }

    const glm::dvec3& corner_at(std::ptrdiff_t corner) const { return vertices_[corners_[std::size_t(corner)]]; }

    bool near(const glm::dvec3& p, const glm::dvec3& q) const {
        const Vector<Exact> way = difference<Exact>(p, q);
        return within_tolerance<Exact>(squared(way.x) + squared(way.y), 1, box_).make_certain();
    }

    /// Whether each corner between two corners of the hull is within the tolerance of one of them.
    bool is_step(std::ptrdiff_t from, std::ptrdiff_t to) const {
        const std::ptrdiff_t count = std::ssize(corners_);
        for (std::ptrdiff_t c = (from + 1) % count; c != to; c = (c + 1) % count) {
            if (!near(corner_at(c), corner_at(from)) && !near(corner_at(c), corner_at(to))) return false;
        }
        return true;
    }

    /// By how many corners the outline advances from one corner to the next that it passes. Negative if it goes back within the
    /// tolerance; none if it leaves the hull's order.
    std::optional<std::ptrdiff_t> corners_ahead(std::ptrdiff_t from, std::ptrdiff_t to) const {
        const std::ptrdiff_t count = std::ssize(corners_), forward = (to - from + count) % count;
        if (forward == 0 || is_step(from, to)) return forward;
        if (near(corner_at(from), corner_at(to)) && is_step(to, from)) return forward - count;
        return std::nullopt;
    }

    /// Whether the vertices between two that are corners keep to the segment between these and do not go back along it.
    bool follows_side(std::size_t from, std::size_t to) const {
        const std::size_t count = outline_.size();
        const glm::dvec3 &start = vertices_[outline_[from]], &end = vertices_[outline_[to]];
        const Vector<Exact> side = difference<Exact>(end, start);
        const Exact squared_side = squared(side.x) + squared(side.y);
        Exact farthest = 0;
        for (std::size_t i = (from + 1) % count; i != to; i = (i + 1) % count) {
            const glm::dvec3& place = vertices_[outline_[i]];
            const Vector<Exact> way = difference<Exact>(place, start);
            const Exact along = way.x * side.x + way.y * side.y;
            if (along <= 0 || along >= squared_side) {
                if (!near(place, along <= 0 ? start : end)) return false;
            } else if (!within_tolerance<Exact>(squared(Exact(side.x * way.y - side.y * way.x)), squared_side, box_)
                            .make_certain()) {
                return false;
            }
            if (along < farthest &&
                !within_tolerance<Exact>(squared(Exact(farthest - along)), squared_side, box_).make_certain())
                return false;
            farthest = std::max(farthest, along);
        }
        return true;
    }

    const Vertices& vertices_;
    std::vector<std::size_t> outline_;
    std::vector<std::size_t> corners_;  // of the hull, in the direction of the outline
    Box3<Exact> box_;
    CGAL::Sign sign_;  // of the area of the outline
};

/// Checks that the outline is convex. Reports how many vertices it dropped because of rounding.
inline PolygonAdmission make_convex(Vertices& vertices) {
    const std::vector<std::size_t> outline = without_repeats(vertices);
    if (is_exactly_convex(vertices, outline)) return {};
    const HullWalk walk(vertices, outline);
    if (!walk.is_once_around()) return {Admission::not_convex};
    vertices = walk.corners();
    return {Admission::admitted, outline.size() - vertices.size()};
}

}  // namespace admission

/// Checks all but the range of depth; sets edge_on and drops vertices where only rounding keeps the outline from being convex.
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
