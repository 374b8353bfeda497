/// ZBuffer: paint each polygon scanline by scanline, keeping at each pixel what is nearest so far.
///
/// Source  E. Catmull's depth buffer with an active edge list; the course's form.
/// Takes   a run with its polygons.
/// Gives   the run's picture and depths: at each pixel centre the nearest polygon, the first of equally near ones.
///         Rows are pixel centres; a convex polygon has exactly two active edges on each of its rows.
/// Time    an addition for each row and edge, a comparison for each covered pixel.
#pragma once

#include "active_edge_list.h"

namespace vidno {

struct ZBuffer {
    template <class Run>
    static void z_buffer(Run& run) {
        using enum Line;
        const auto first_depth = run.set.first_depth(run.kernel);
        run.depth_buffer.clear(run.area, first_depth);
        run.trace.clear(Z1, run.background, first_depth);
        for (const auto& polygon : run.polygons) {
            if (polygon.edge_on) continue;
            run.trace.polygon(Z2, polygon);
            scan_polygon(run, polygon);
        }
    }

private:
    template <class Run>
    static void scan_polygon(Run& run, const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        auto& trace = run.trace;

        const auto& box = polygon.box;
        const int bottom = run.set.rows_end(run.area);
        int row = run.kernel.first_centre(box.ymin, run.area.y, bottom);  // y_t
        const int last_row = run.kernel.last_centre(box.ymax, run.area.y, bottom);
        auto edges = sorted_edges(run, polygon);  // S
        trace.extent(Z4, box.ymin, box.ymax);

        std::vector<ActiveEdge<typename Run::Arithmetic>> active_edges;  // AEL
        int next_start = row;
        int next_end = no_row;
        while (row <= last_row) {
            trace.scanline(Z6, run.set.scanline(run.kernel, polygon, row), row);
            if (row == next_start) {
                const auto later = [&](const auto& edge) { return edge.first_row > row; };
                const auto starting = std::find_if(edges.begin(), edges.end(), later);
                for (auto edge = edges.begin(); edge != starting; ++edge) {
                    if (edge->last_row < edge->first_row) continue;
                    if (!edge->level()) {
                        active_edges.push_back(entry_of(run, polygon, *edge));
                        trace.ael_add(Z8, active_edges.back());
                    } else {
                        trace.horizontal(Z9, *edge);
                        run.show_line(Z9, row, edge->upper, edge->lower, polygon);
                    }
                }
                next_start = starting == edges.end() ? no_row : starting->first_row;
                trace.leave(Z10, Part{edges.begin(), starting}, next_start);
                edges.erase(edges.begin(), starting);
                const auto left_of = [&](const auto& a, const auto& b) { return run.kernel.left_of(a, b, row); };
                std::stable_sort(active_edges.begin(), active_edges.end(), left_of);
                next_end = first_end(active_edges);
                trace.ael_sort(Z12, active_edges, next_end);
            }
            for (std::size_t i = 0; i + 1 < active_edges.size(); i += 2) {
                run.show_line(Z14, row, active_edges[i], active_edges[i + 1], polygon);
            }
            ++row;
            if (row >= next_end) {
                const auto stays = [&](const auto& edge) { return edge.last_row >= row; };
                const auto ended = std::stable_partition(active_edges.begin(), active_edges.end(), stays);
                next_end = first_end(Part{active_edges.begin(), ended});
                trace.ael_drop(Z16, Part{ended, active_edges.end()}, next_end);
                active_edges.erase(ended, active_edges.end());
            }
            for (auto& edge : active_edges) {
                edge.x += edge.dx;
                edge.z += edge.dz;
                trace.ael_step(Z17, edge);
            }
        }
    }

    /// S: the edges by rising y1; the depth of a vertex is that of the plane.
    template <class Run>
    static auto sorted_edges(Run& run, const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        std::vector<EdgeEnd<typename Run::Arithmetic>> vertices;
        for (const auto& vertex : polygon.vertices) {
            vertices.push_back({vertex.x, vertex.y, run.kernel.finite(run.depth(Z3, polygon, vertex))});
        }
        std::vector<PolygonEdge<typename Run::Arithmetic>> edges;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto& next = vertices[(i + 1) % vertices.size()];
            edges.push_back(edge_between(run, polygon, int(i), vertices[i], next));
        }
        const auto above = [](const auto& a, const auto& b) { return a.upper.y < b.upper.y; };
        std::stable_sort(edges.begin(), edges.end(), above);
        for (const auto& edge : edges) run.trace.edge(Z3, edge);
        return edges;
    }
};

}  // namespace vidno
