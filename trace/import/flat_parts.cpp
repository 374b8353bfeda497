#include "import/flat_parts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace vidno {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corner = std::array<double, 3>;

/// An edge without direction, and a face that has it.
struct EdgeOfFace {
    Corner low, high;
    std::size_t face;

    bool operator<(const EdgeOfFace& other) const {
        return std::tie(low, high, face) < std::tie(other.low, other.high, other.face);
    }
    bool is_edge_of(const EdgeOfFace& other) const { return low == other.low && high == other.high; }
};

Corner corner_at(const glm::dvec3& point) { return {point.x + 0.0, point.y + 0.0, point.z + 0.0}; }  // no -0

std::vector<EdgeOfFace> sorted_edges(const MeshSoup& mesh) {
    std::vector<EdgeOfFace> edges;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const auto& corners = mesh.faces[face].corners;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Corner p = corner_at(mesh.points[corners[i]]);
            const Corner q = corner_at(mesh.points[corners[(i + 1) % corners.size()]]);
            if (p != q) edges.push_back({std::min(p, q), std::max(p, q), face});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

Kernel::Point_3 exact_point(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// Three corners of a face that are not collinear, if it has such.
std::optional<std::array<Kernel::Point_3, 3>> plane_of(const MeshSoup& mesh, std::size_t face) {
    const auto& corners = mesh.faces[face].corners;
    if (corners.size() < 3) return std::nullopt;
    const Kernel::Point_3 p = exact_point(mesh.points[corners[0]]);
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const Kernel::Point_3 q = exact_point(mesh.points[corners[i - 1]]), r = exact_point(mesh.points[corners[i]]);
        if (!CGAL::collinear(p, q, r)) return std::array{p, q, r};
    }
    return std::nullopt;
}

bool are_in_one_plane(const MeshSoup& mesh, std::size_t face, std::size_t other) {
    const auto plane = plane_of(mesh, face);
    if (!plane || !plane_of(mesh, other)) return false;
    const auto is_on = [&](std::size_t corner) {
        return CGAL::coplanar((*plane)[0], (*plane)[1], (*plane)[2], exact_point(mesh.points[corner]));
    };
    const auto& own = mesh.faces[face].corners;
    const auto& others = mesh.faces[other].corners;
    return std::all_of(own.begin(), own.end(), is_on) && std::all_of(others.begin(), others.end(), is_on);
}

}  // namespace

std::vector<std::size_t> flat_parts(const MeshSoup& mesh, const std::vector<std::optional<Color>>& colors) {
    std::vector<std::size_t> first(mesh.faces.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    const auto root = [&](std::size_t face) {
        while (first[face] != face) face = first[face] = first[first[face]];
        return face;
    };
    const auto edges = sorted_edges(mesh);
    for (std::size_t i = 1; i < edges.size(); ++i) {
        if (!edges[i].is_edge_of(edges[i - 1])) continue;
        const std::size_t one = edges[i - 1].face, other = edges[i].face;
        if (root(one) == root(other) || colors[one] != colors[other]) continue;
        if (mesh.faces[one].group != mesh.faces[other].group) continue;
        if (are_in_one_plane(mesh, one, other)) {
            const auto [low, high] = std::minmax({root(one), root(other)});
            first[high] = low;
        }
    }
    for (std::size_t face = 0; face < first.size(); ++face) first[face] = root(face);
    return first;
}

}  // namespace vidno
