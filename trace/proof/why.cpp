#include "proof/why.h"

#include "scene/rational_polygon.h"

namespace vidno {

namespace {

/// How far the line of an edge passes from a place, and on which side: less than 0 to the left or above.
struct Passing {
    int edge;
    bool in_row;
    Rational offset;

    Rational away() const { return offset < 0 ? Rational(-offset) : offset; }
};

/// None for an edge without length.
std::optional<Passing> passing(const RationalPolygon& polygon, std::size_t edge, const Point<Rational>& at) {
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

struct Reasons::Polygons : RationalPolygons {
    using RationalPolygons::RationalPolygons;

    bool holds(int polygon, int x, int y) {
        const auto [xmin, ymin, xmax, ymax] = box(polygon);
        if (xmin > x + 0.5 || xmax < x + 0.5 || ymin > y + 0.5 || ymax < y + 0.5) return false;
        return at(polygon).holds(centre_of_pixel(x, y));
    }

    /// The polygon that would show without this one.
    std::optional<int> owner(int x, int y, std::optional<int> without) {
        const Point<Rational> centre = centre_of_pixel(x, y);
        std::optional<int> nearest;
        Rational depth;
        for (int i = 0; i < count(); ++i) {
            if (i == without || !holds(i, x, y)) continue;
            const Rational z = at(i).depth(centre);
            if (nearest && z <= depth) continue;
            nearest = i;
            depth = z;
        }
        return nearest;
    }
};

Reasons::Reasons(const Scene& scene) : polygons_(std::make_unique<Polygons>(scene)) {}
Reasons::~Reasons() = default;

std::vector<int> Reasons::holding(int x, int y) const {
    std::vector<int> found;
    for (int i = 0; i < polygons_->count(); ++i) {
        if (polygons_->holds(i, x, y)) found.push_back(i);
    }
    return found;
}

std::optional<int> Reasons::owner(int x, int y) const { return polygons_->owner(x, y, std::nullopt); }

AtPixel Reasons::at(int x, int y, int polygon, std::optional<int> owner) const {
    const RationalPolygon& own = polygons_->at(polygon);
    AtPixel found{.polygon = polygon};
    if (own.is_edge_on()) {
        found.standing = Standing::edge_on;
        return found;
    }
    const Point<Rational> at = centre_of_pixel(x, y);
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
    const Rational gap = shows ? depth - polygons_->at(*rival).depth(at) : polygons_->at(*rival).depth(at) - depth;
    found.wins_ties = polygon < *rival;
    if (shows) found.next = rival;
    if (gap > 0 || (gap == 0 && (shows || !found.wins_ties))) found.gap = Fraction{Exact::fraction(gap)};
    return found;
}

}  // namespace vidno
