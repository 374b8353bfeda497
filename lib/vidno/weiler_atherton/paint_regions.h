/// PaintRegions: the picture of the visible regions, at the centres of its pixels.
///
/// Takes   a run with its visible regions.
/// Gives   the run's picture: at each pixel centre the colour of the nearest polygon, the first of equally near ones.
/// Time    one comparison for each row and edge of a region; for each of its centres, one with each earlier polygon
///         that holds it.
///
/// A region is closed, so a centre on an outline may belong to several regions. One of them has the nearest depth
/// there, since that depth is the limit of what is visible next to it. A polygon without a region there may be equally
/// near if it touches the polygon that hides it, in a point or along an edge. It shows if it comes first in the scene.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "../insertion_sort.h"
#include "point_in_region.h"
#include "weiler_atherton_run.h"

namespace vidno {

struct PaintRegions {
    template <class Run>
    static void paint_regions(Run& run) {
        using enum Line;
        const Area& area = run.area;
        std::vector<const SourcePolygon<typename Run::Number>*> shown(std::size_t(area.width) *
                                                                      std::size_t(area.height));
        for (const auto& piece : run.visible) {
            const auto earlier = earlier_ones(run, piece);
            for (int y = area.y; y < area.bottom(); ++y) {
                const auto row = row_of(shown, area, y);
                for (const auto& [first, end] : columns_on_row(run, piece.region, y)) {
                    for (int x = first; x < end; ++x) {
                        const auto centre = run.kernel.place(x + 0.5, y + 0.5);
                        const auto* polygon = first_of_equals(run, *piece.polygon, earlier, centre);  // PR2
                        if (row[x] && !is_before(run, *polygon, *row[x], centre)) continue;
                        row[x] = polygon;
                        run.picture.paint(x, y, polygon->color);
                        run.trace.paint(PR3, *polygon, x, y);
                    }
                }
            }
            run.trace.region_painted(PR3);
        }
    }

private:
    /// first <= x < end
    struct ColumnRange {
        int first, end;
    };

    /// The centres of a row that a closed region holds: those that it holds just above the row, or just below it. So
    /// vertices on the row count as below it in one pass, and as above it in the other. In each pass, pairs of edges
    /// that cross the row bound spans.
    template <class Run>
    static std::vector<ColumnRange> columns_on_row(Run& run, const Region<typename Run::Number>& region, int row) {
        using enum Line;
        const auto& kernel = run.kernel;
        const Area& area = run.area;
        std::vector<ColumnRange> columns;
        const auto centre = kernel.place(area.x + 0.5, row + 0.5);
        for (const Sign on_row : {Sign::positive, Sign::negative}) {
            const auto is_below = [&](const auto& vertex) {
                const Sign order = kernel.order_of_rows(vertex.at, centre);
                return (order == Sign::zero ? on_row : order) == Sign::positive;
            };
            std::vector<typename Run::Number> ends;
            for (const auto& loop : region.loops) {
                bool from_below = is_below(loop.back());
                for_each_edge(loop, [&](const auto& from, const auto& to) {
                    const bool to_below = is_below(to);
                    if (from_below != to_below) ends.push_back(kernel.on_row(*from.after, centre));
                    from_below = to_below;
                });
            }
            const auto left_of = [&](const auto& a, const auto& b) { return kernel.compare(a, b) == Sign::negative; };
            insertion_sort(ends, left_of);
            for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
                const int first = kernel.first_centre(ends[i], area.x, area.right());
                const int end = kernel.last_centre(ends[i + 1], area.x, area.right()) + 1;
                run.trace.row(PR1, row, ends[i], ends[i + 1], first, end);
                columns.push_back({first, end});
            }
        }
        return columns;
    }

    static bool holds_closed(const auto& kernel, const auto& region, const auto& place) {
        return holds(kernel, region, place) || is_on_outline(kernel, region, place);
    }

    static bool in_box(const auto& box, const auto& place) {
        return !(place.y < box.ymin) && !(box.ymax < place.y) && !(place.x < box.xmin) && !(box.xmax < place.x);
    }

    /// The facets of polygons before this one in the scene that share area with it.
    template <class Run>
    static auto earlier_ones(const Run& run, const typename Run::Piece& piece) {
        std::vector<const typename Run::Piece*> earlier;
        for (const auto& facet : run.facets) {
            if (facet.polygon->index < piece.polygon->index && !run.apart(facet, piece)) earlier.push_back(&facet);
        }
        return earlier;
    }

    static auto first_of_equals(auto& run, const auto& polygon, const auto& earlier, const auto& place) {
        using enum Line;
        const auto* first = &polygon;
        for (const auto* facet : earlier) {
            if (facet->polygon->index >= first->index || !in_box(facet->box, place)) continue;
            if (run.order(PR2, *facet->polygon, polygon, place) != Sign::zero) continue;
            if (holds_closed(run.kernel, facet->region, place)) first = facet->polygon;
        }
        return first;
    }

    static bool is_before(auto& run, const auto& polygon, const auto& other, const auto& place) {
        using enum Line;
        if (&polygon == &other) return false;
        const Sign order = run.order(PR3, polygon, other, place);
        return order == Sign::positive || (order == Sign::zero && polygon.index < other.index);
    }
};

}  // namespace vidno
