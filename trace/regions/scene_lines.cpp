#include "regions/scene_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "vidno/kernels/exact.h"

namespace vidno {

namespace {

struct ExactPoint {
    Rational x, y;
};
struct ExactPiece {
    ExactPoint from, to;
};
using Pieces = std::vector<ExactPiece>;

Rational exact_value(const Value& value) {
    if (!value.fraction) return Rational(value.number);
    using Integer = CGAL::Fraction_traits<Rational>::Numerator_type;
    const std::string& text = *value.fraction;
    const auto slash = text.find('/');
    return Rational(Integer(text.substr(0, slash))) / Rational(Integer(text.substr(slash + 1)));
}

bool finite(const ValuePoint& point) { return std::isfinite(number_of(point.x)) && std::isfinite(number_of(point.y)); }

void add_edges(Pieces& to, const std::vector<ExactPoint>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) to.push_back({loop[i], loop[(i + 1) % loop.size()]});
}

/// The edges of a region; none if a vertex is not finite.
Pieces edges_of(const ShownRegion& region) {
    Pieces edges;
    for (const auto& loop : region.loops) {
        if (!std::all_of(loop.begin(), loop.end(), finite)) return {};
        std::vector<ExactPoint> points;
        for (const auto& [x, y] : loop) points.push_back({exact_value(x), exact_value(y)});
        add_edges(edges, points);
    }
    return edges;
}

Pieces edges_of(const ScenePolygon& polygon) {
    Pieces edges;
    std::vector<ExactPoint> points;
    for (const auto& vertex : polygon.vertices) points.push_back({Rational(vertex.x), Rational(vertex.y)});
    add_edges(edges, points);
    return edges;
}

/// The place of a point along a piece, from 0 to 1 between its ends; none if it is not on the line of the piece.
std::optional<Rational> place_along(const ExactPiece& piece, const ExactPoint& point) {
    const Rational dx = piece.to.x - piece.from.x, dy = piece.to.y - piece.from.y;
    const Rational px = point.x - piece.from.x, py = point.y - piece.from.y;
    if (dx * py != dy * px) return std::nullopt;
    return Rational(dx != 0 ? px / dx : py / dy);
}

ExactPoint point_at(const ExactPiece& piece, const Rational& place) {
    return {piece.from.x + (piece.to.x - piece.from.x) * place, piece.from.y + (piece.to.y - piece.from.y) * place};
}

/// What is left of a piece without the others on its line.
Pieces without(const ExactPiece& piece, const Pieces& others) {
    if (piece.from.x == piece.to.x && piece.from.y == piece.to.y) return {};
    std::vector<std::pair<Rational, Rational>> covered;
    for (const auto& other : others) {
        const auto from = place_along(piece, other.from), to = place_along(piece, other.to);
        if (from && to) covered.emplace_back(std::min(*from, *to), std::max(*from, *to));
    }
    std::sort(covered.begin(), covered.end());
    Pieces left;
    Rational reached = 0;
    const auto keep_until = [&](const Rational& end) {
        if (reached < end) left.push_back({point_at(piece, reached), point_at(piece, end)});
    };
    for (const auto& [begin, end] : covered) {
        keep_until(std::min(begin, Rational(1)));
        reached = std::max(reached, end);
    }
    keep_until(1);
    return left;
}

bool are_of_one_face(const ShownRegion& one, const ShownRegion& other, const Scene& scene) {
    const auto polygon = [&](const ShownRegion& region) { return std::size_t(region.polygon.index); };
    return polygon(one) == polygon(other) ||
           are_of_one_face(scene.polygons[polygon(one)], scene.polygons[polygon(other)]);
}

void append(Pieces& to, const Pieces& pieces) { to.insert(to.end(), pieces.begin(), pieces.end()); }

std::vector<LinePiece> in_doubles(const Pieces& pieces) {
    const auto place = [](const ExactPoint& p) { return std::array{nearest_double(p.x), nearest_double(p.y)}; };
    std::vector<LinePiece> result;
    for (const auto& [from, to] : pieces) result.push_back({place(from), place(to)});
    return result;
}

/// The border of a region; `edges` are those of each region.
Pieces border_of(std::size_t region, const std::vector<Pieces>& edges, const std::vector<ShownRegion>& regions,
                 const Scene& scene) {
    Pieces of_the_same;  // other regions of the face
    for (std::size_t k = 0; k < regions.size(); ++k) {
        if (k != region && are_of_one_face(regions[k], regions[region], scene)) append(of_the_same, edges[k]);
    }
    Pieces border;
    for (const auto& edge : edges[region]) append(border, without(edge, of_the_same));
    return border;
}

}  // namespace

std::vector<LinePiece> border_of(const std::vector<ShownRegion>& regions, std::size_t region, const Scene& scene) {
    std::vector<Pieces> edges(regions.size());
    for (std::size_t k = 0; k < regions.size(); ++k) {
        if (are_of_one_face(regions[k], regions[region], scene)) edges[k] = edges_of(regions[k]);
    }
    return in_doubles(border_of(region, edges, regions, scene));
}

SceneLines scene_lines(const std::vector<ShownRegion>& regions, const Scene& scene) {
    std::vector<Pieces> edges;
    for (const auto& region : regions) edges.push_back(edges_of(region));
    Pieces visible, hidden;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        for (const auto& piece : border_of(i, edges, regions, scene)) append(visible, without(piece, visible));
    }
    for (const auto& polygon : scene.polygons) {
        if (polygon.edge_on) continue;
        Pieces cuts;
        for (const auto& other : scene.polygons) {
            if (&other != &polygon && are_of_one_face(other, polygon)) append(cuts, edges_of(other));
        }
        for (const auto& edge : edges_of(polygon)) {
            for (const auto& drawn : without(edge, cuts)) {
                for (const auto& piece : without(drawn, visible)) append(hidden, without(piece, hidden));
            }
        }
    }
    return {in_doubles(visible), in_doubles(hidden)};
}

}  // namespace vidno
