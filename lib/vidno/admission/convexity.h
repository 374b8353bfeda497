/// Whether an outline is convex: the rule in ../admission.h.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "../admitted.h"
#include "measures.h"

namespace vidno::admission {

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

/// Follows an outline around the convex hull of its vertices.
class HullWalk {
public:
    /// The outline holds indices of vertices at different places, in either direction. Seen from the viewer its area is
    /// not 0.
    HullWalk(const Vertices& vertices, std::vector<std::size_t> outline)
        : vertices_(vertices),
          outline_(std::move(outline)),
          box_(box_of<Exact>(vertices)),
          sign_(CGAL::sign(normal_of<Exact>(vertices).z)) {
        find_corners();
        if (sign_ < 0) std::reverse(corners_.begin(), corners_.end());
        std::rotate(corners_.begin(), std::min_element(corners_.begin(), corners_.end()), corners_.end());
    }

    /// Whether the outline is convex.
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

    /// The monotone chain of Andrew: from the leftmost corner along the upper side of the screen and back along the
    /// lower one.
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

    /// By how many corners the outline advances from one corner to the next that it passes. Negative if it goes back
    /// within the tolerance; none if it leaves the hull's order.
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

}  // namespace vidno::admission
