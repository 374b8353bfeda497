#include "proof/why.h"

#include <algorithm>
#include <utility>

#include "vidno/kernels/exact.h"
#include "vidno/warnock/initialize_polygon.h"

namespace vidno {

namespace {

struct InRationals {
    using Number = Rational;
    using Vertices = std::vector<Vertex<Rational>>;
};

struct PolygonAtPixel {
    InRationals::Vertices vertices;
    Plane<Rational> plane;  // c is 0 for an edge-on polygon, and has the sign of the inside
    Box<double> box;

    explicit PolygonAtPixel(const ScenePolygon& given)
        : plane{}, box{given.vertices[0].x, given.vertices[0].y, given.vertices[0].x, given.vertices[0].y} {
        for (const auto& v : given.vertices) {
            vertices.push_back({v.x, v.y, v.z});
            box = {std::min(box.xmin, v.x), std::min(box.ymin, v.y), std::max(box.xmax, v.x), std::max(box.ymax, v.y)};
        }
        InRationals numbers;
        plane = InitializePolygon::initialize_polygon(numbers, vertices);
    }

    bool is_edge_on() const { return plane.c == 0; }

    /// Positive on the inner side of the edge.
    Rational inward(std::size_t edge, const Point<Rational>& at) const {
        const auto &p = vertices[edge], &q = vertices[(edge + 1) % vertices.size()];
        const Rational cross = (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x);
        return plane.c > 0 ? cross : Rational(-cross);
    }
    bool holds(const Point<Rational>& at) const {
        for (std::size_t edge = 0; edge < vertices.size(); ++edge) {
            if (inward(edge, at) < 0) return false;
        }
        return !is_edge_on();
    }
    Rational depth(const Point<Rational>& at) const { return -(plane.a * at.x + plane.b * at.y + plane.d) / plane.c; }
};

/// How far the line of an edge passes from a place, and on which side: less than 0 to the left or above.
struct Passing {
    int edge;
    bool in_row;
    Rational offset;

    Rational away() const { return offset < 0 ? Rational(-offset) : offset; }
};

/// None for an edge without length.
std::optional<Passing> passing(const PolygonAtPixel& polygon, std::size_t edge, const Point<Rational>& at) {
    const auto &p = polygon.vertices[edge], &q = polygon.vertices[(edge + 1) % polygon.vertices.size()];
    const Rational dx = q.x - p.x, dy = q.y - p.y;
    if (dx == 0 && dy == 0) return std::nullopt;
    const bool in_row = CGAL::abs(dy) >= CGAL::abs(dx);  // the steeper a line is, the nearer it passes in the row
    if (in_row) return Passing{int(edge), true, Rational(p.x + dx * (at.y - p.y) / dy - at.x)};
    return Passing{int(edge), false, Rational(p.y + dy * (at.x - p.x) / dx - at.y)};
}

PassingEdge as_shown(const Passing& passing) {
    return {passing.edge, passing.in_row, Sign{int(CGAL::sign(passing.offset))}, {Exact::fraction(passing.away())}};
}

}  // namespace

struct Reasons::Polygons {
    std::vector<PolygonAtPixel> all;

    static Point<Rational> centre(int x, int y) { return {Rational(x + 0.5), Rational(y + 0.5)}; }

    /// The polygon that would show without this one.
    std::optional<int> owner(int x, int y, std::optional<int> without) const {
        const Point<Rational> at = centre(x, y);
        std::optional<int> nearest;
        Rational depth;
        for (int i = 0; i < int(all.size()); ++i) {
            const PolygonAtPixel& polygon = all[std::size_t(i)];
            const auto& box = polygon.box;
            if (i == without || box.xmin > x + 0.5 || box.xmax < x + 0.5 || box.ymin > y + 0.5 || box.ymax < y + 0.5 ||
                !polygon.holds(at)) {
                continue;
            }
            const Rational z = polygon.depth(at);
            if (nearest && z <= depth) continue;
            nearest = i;
            depth = z;
        }
        return nearest;
    }
};

Reasons::Reasons(const AdmittedScene& scene) {
    Polygons polygons;
    for (const auto& polygon : scene->polygons) polygons.all.emplace_back(polygon);
    polygons_ = std::make_unique<const Polygons>(std::move(polygons));
}
Reasons::~Reasons() = default;

std::optional<int> Reasons::owner(int x, int y) const { return polygons_->owner(x, y, std::nullopt); }

AtPixel Reasons::at(int x, int y, int polygon, std::optional<int> owner) const {
    const auto exact = [&](int place) -> const PolygonAtPixel& { return polygons_->all[std::size_t(place)]; };
    const PolygonAtPixel& own = exact(polygon);
    AtPixel found{.polygon = polygon};
    if (own.is_edge_on()) {
        found.standing = Standing::edge_on;
        return found;
    }
    const Point<Rational> at = Polygons::centre(x, y);
    const Rational depth = own.depth(at);
    found.depth = Fraction{Exact::fraction(depth)};
    const bool shows = owner == polygon;
    const bool holds = shows || own.holds(at);
    found.standing = shows ? Standing::shows : holds ? Standing::behind : Standing::beside;

    std::optional<Passing> nearest;
    for (std::size_t edge = 0; edge < own.vertices.size(); ++edge) {
        const auto passes = passing(own, edge, at);
        if (!passes) continue;
        if (!holds && own.inward(edge, at) < 0) found.edges.push_back(as_shown(*passes));
        if (!nearest || passes->away() < nearest->away()) nearest = passes;
    }
    if (shows && nearest) found.edges.push_back(as_shown(*nearest));

    const auto rival = shows ? polygons_->owner(x, y, polygon) : owner;
    if (!rival) return found;
    const Rational gap = shows ? depth - exact(*rival).depth(at) : exact(*rival).depth(at) - depth;
    found.wins_ties = polygon < *rival;
    if (shows) found.next = rival;
    if (gap > 0 || (gap == 0 && (shows || !found.wins_ties))) found.gap = Fraction{Exact::fraction(gap)};
    return found;
}

}  // namespace vidno
