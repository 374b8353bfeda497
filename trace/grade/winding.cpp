#include "grade/winding.h"

#include <algorithm>

namespace vidno::grading {

namespace {

/// An edge that is not level. To its right the winding number of its layer is greater by `turn` than to its left.
struct LoopEdge {
    Point2 upper, lower;
    std::size_t layer;
    int turn;

    Rational at(const Rational& y) const { return upper.x + (lower.x - upper.x) * (y - upper.y) / (lower.y - upper.y); }
};

std::vector<LoopEdge> loop_edges(const std::vector<Layer>& layers) {
    std::vector<LoopEdge> edges;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        for (const Outline2& loop : layers[layer]) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Point2 &from = loop[i], &to = loop[(i + 1) % loop.size()];
                if (to.y < from.y) edges.push_back({to, from, layer, 1});
                if (from.y < to.y) edges.push_back({from, to, layer, -1});
            }
        }
    }
    return edges;
}

/// The heights of all ends and crossings of edges, in order.
std::vector<Rational> heights_of_edges(const std::vector<LoopEdge>& edges) {
    std::vector<Rational> heights;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const LoopEdge& own = edges[i];
        heights.push_back(own.upper.y);
        heights.push_back(own.lower.y);
        for (std::size_t j = 0; j < i; ++j) {
            const Rational top = std::max(own.upper.y, edges[j].upper.y),
                           bottom = std::min(own.lower.y, edges[j].lower.y);
            if (top >= bottom) continue;
            const Rational before = own.at(top) - edges[j].at(top), after = own.at(bottom) - edges[j].at(bottom);
            if ((before < 0 && after > 0) || (before > 0 && after < 0))
                heights.push_back(top + (bottom - top) * before / (before - after));
        }
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    return heights;
}

}  // namespace

/// Sums horizontal bands. No edges cross in a band, so what lies between two neighbouring edges is a trapezium, and its
/// area is its width on the band's centre line times the band's height.
double area_where(const std::vector<Layer>& layers, const std::function<bool(const std::vector<int>&)>& is_wanted) {
    const std::vector<LoopEdge> edges = loop_edges(layers);
    const std::vector<Rational> heights = heights_of_edges(edges);
    Rational area(0);
    for (std::size_t band = 1; band < heights.size(); ++band) {
        const Rational &top = heights[band - 1], &bottom = heights[band], y = (top + bottom) / 2;
        std::vector<std::pair<Rational, const LoopEdge*>> met;
        for (const LoopEdge& edge : edges) {
            if (edge.upper.y < y && y < edge.lower.y) met.emplace_back(edge.at(y), &edge);
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
