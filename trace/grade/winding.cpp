#include "grade/winding.h"

#include <algorithm>

namespace vidno::grading {

namespace {

/// An edge that is not level. To its right the winding number of its layer is greater by `turn` than to its left.
struct Side {
    Point2 upper, lower;
    std::size_t layer;
    int turn;

    Rational at(const Rational& y) const { return upper.x + (lower.x - upper.x) * (y - upper.y) / (lower.y - upper.y); }
};

std::vector<Side> sides_of(const std::vector<Layer>& layers) {
    std::vector<Side> sides;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        for (const Outline2& loop : layers[layer]) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Point2 &from = loop[i], &to = loop[(i + 1) % loop.size()];
                if (to.y < from.y) sides.push_back({to, from, layer, 1});
                if (from.y < to.y) sides.push_back({from, to, layer, -1});
            }
        }
    }
    return sides;
}

/// The heights of all ends and crossings of sides, in order.
std::vector<Rational> heights_of(const std::vector<Side>& sides) {
    std::vector<Rational> heights;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side& own = sides[i];
        heights.push_back(own.upper.y);
        heights.push_back(own.lower.y);
        for (std::size_t j = 0; j < i; ++j) {
            const Rational top = std::max(own.upper.y, sides[j].upper.y),
                           bottom = std::min(own.lower.y, sides[j].lower.y);
            if (top >= bottom) continue;
            const Rational before = own.at(top) - sides[j].at(top), after = own.at(bottom) - sides[j].at(bottom);
            if ((before < 0 && after > 0) || (before > 0 && after < 0))
                heights.push_back(top + (bottom - top) * before / (before - after));
        }
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    return heights;
}

}  // namespace

/// Sums horizontal bands. No sides cross in a band, so what lies between two neighbouring sides is a trapezium, and its area is its width
/// on the band's centre line times the band's height.
double area_where(const std::vector<Layer>& layers, const std::function<bool(const std::vector<int>&)>& is_wanted) {
    const std::vector<Side> sides = sides_of(layers);
    const std::vector<Rational> heights = heights_of(sides);
    Rational area(0);
    for (std::size_t band = 1; band < heights.size(); ++band) {
        const Rational &top = heights[band - 1], &bottom = heights[band], y = (top + bottom) / 2;
        std::vector<std::pair<Rational, const Side*>> met;
        for (const Side& side : sides) {
            if (side.upper.y < y && y < side.lower.y) met.emplace_back(side.at(y), &side);
        }
        std::sort(met.begin(), met.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<int> windings(layers.size());
        Rational width(0);
        for (std::size_t i = 0; i + 1 < met.size(); ++i) {
            windings[met[i].second->layer] += met[i].second->turn;
            if (is_wanted(windings)) width += met[i + 1].first - met[i].first;
        }
        area += width * (bottom - top);
    }
    return CGAL::to_double(area);
}

}  // namespace vidno::grading
