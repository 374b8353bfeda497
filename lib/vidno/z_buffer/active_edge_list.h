/// The lists of the Z-buffer procedure: S, a polygon's edges from the top, and AEL, those that cross the scanline.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "../part.h"
#include "../run.h"

namespace vidno {

/// The minimum of an empty list; no row comes after it.
inline constexpr int no_row = std::numeric_limits<int>::max();

/// A vertex with the depth of the plane.
template <Kernel K>
using EdgeEnd = Vertex<typename K::Coordinate, typename K::Interpolated>;

/// An edge of a polygon from its upper end to its lower one; a level edge goes from left to right.
template <Kernel K>
struct PolygonEdge {
    int index;  // from vertex `index` to the next
    EdgeEnd<K> upper, lower;
    int first_row, last_row;  // the rows whose centres it crosses; none if last < first

    bool level() const { return upper.y == lower.y; }
};

/// An entry of AEL: an edge, where it meets the scanline, and the change from row to row.
template <Kernel K>
struct ActiveEdge : PolygonEdge<K> {
    typename K::Number x, dx;
    typename K::Interpolated z, dz;
};

/// The lists of a polygon. They keep their memory from polygon to polygon.
template <Kernel K>
struct EdgeLists {
    std::vector<EdgeEnd<K>> vertices;
    std::vector<PolygonEdge<K>> edges;        // S
    std::vector<ActiveEdge<K>> active_edges;  // AEL
};

/// The edge with its rows: those of the area with y1 <= centre < y2. The end is included only at the polygon's lowest
/// point, so that the closed outline is painted; elsewhere the next edge takes over.
template <class Run>
PolygonEdge<typename Run::Arithmetic> edge_between(const Run& run, const Polygon<typename Run::Arithmetic>& polygon,
                                                   int index, auto upper, auto lower) {
    if (lower.y < upper.y || (lower.y == upper.y && lower.x < upper.x)) std::swap(upper, lower);
    const int top = run.area.y;
    const int bottom = run.set.rows_end(run.area);
    const int first_row = run.kernel.first_centre(upper.y, top, bottom);
    const int last_row = lower.y == polygon.box.ymax ? run.kernel.last_centre(lower.y, top, bottom)
                                                     : run.set.row_after(run.kernel, lower.y, top, bottom) - 1;
    return {index, upper, lower, first_row, last_row};
}

/// The entry of an edge that is not level, stepped to its first row.
template <class Run>
ActiveEdge<typename Run::Arithmetic> entry_of(const Run& run, const Polygon<typename Run::Arithmetic>& polygon,
                                              const PolygonEdge<typename Run::Arithmetic>& edge) {
    using Number = typename Run::Number;
    using Interpolated = typename Run::Interpolated;
    const auto& [x1, y1, z1] = edge.upper;
    const auto& [x2, y2, z2] = edge.lower;
    const Number dx = (x2 - x1) / (y2 - y1);
    const auto dz = Interpolated((z2 - z1) / (y2 - y1));
    const Number rows = run.set.scanline(run.kernel, polygon, edge.first_row) - y1;
    return {edge, x1 + rows * dx, dx, Interpolated(z1 + rows * dz), dz};
}

/// The first row that some entry no longer reaches.
int first_end(const auto& active_edges) {
    int end = no_row;
    for (const auto& edge : active_edges) end = std::min(end, edge.last_row + 1);
    return end;
}

}  // namespace vidno
