/// ZBuffer: paints each polygon scanline by scanline, keeping at each pixel the nearest polygon so far.
///
/// Source  E. Catmull's depth buffer with an active edge list; the course's form.
/// Takes   a run with its polygons.
/// Gives   the run's picture and depths: at each pixel centre the nearest polygon, the first of equally near ones.
///         Rows are pixel centres; a convex polygon has exactly two active edges on each of its rows.
/// Time    one addition for each row and edge, one comparison for each covered pixel.
#pragma once

#include "../insertion_sort.h"
#include "active_edge_list.h"

namespace vidno {

struct ZBuffer {
    template <class Run>
    static void z_buffer(Run& run) {
        using enum Line;
        const auto first_depth = run.set.first_depth(run.kernel);
        run.depth_buffer.clear(run.area, first_depth);
        run.trace.clear(Z1, run.background, first_depth);
        EdgeLists<typename Run::Arithmetic> lists;
        for (const auto& polygon : run.polygons) {
            if (polygon.edge_on) continue;
            run.trace.polygon(Z2, polygon);
            scan_polygon(run, polygon, lists);
        }
    }

private:
    template <class Run>
    static void scan_polygon(Run& run, const Polygon<typename Run::Arithmetic>& polygon,
                             EdgeLists<typename Run::Arithmetic>& lists) {
        using enum Line;
        const auto& box = polygon.box;
        const int bottom = run.set.rows_end(run.area);
        int row = run.kernel.first_centre(box.ymin, run.area.y, bottom);  // y_t
        const int last_row = run.kernel.last_centre(box.ymax, run.area.y, bottom);
        sort_edges(run, polygon, lists);
        run.trace.extent(Z4, box.ymin, box.ymax);

        auto first_left = lists.edges.begin();  // of S: the edges before it have begun
        auto& active_edges = lists.active_edges;
        active_edges.clear();
        int next_start = row;
        int next_end = no_row;
        while (row <= last_row) {
            run.trace.scanline(Z6, run.set.scanline(run.kernel, polygon, row), row);
            if (row == next_start) {
                next_start = start_edges(run, polygon, lists, first_left, row);
                next_end = sort_active_edges(run, active_edges, row);
            }
            for (std::size_t i = 0; i + 1 < active_edges.size(); i += 2) {
                run.show_line(Z14, row, active_edges[i], active_edges[i + 1], polygon);
            }
            ++row;
            if (row >= next_end) next_end = drop_ended(run, active_edges, row);
            for (auto& edge : active_edges) {
                edge.x += edge.dx;
                edge.z += edge.dz;
                run.trace.ael_step(Z17, edge);
            }
        }
    }

    /// Z7 to Z10: the edges of S that start on the row join AEL; a level one is shown at once. Gives the row on which
    /// the next ones start.
    template <class Run>
    static int start_edges(Run& run, const Polygon<typename Run::Arithmetic>& polygon,
                           EdgeLists<typename Run::Arithmetic>& lists, auto& first_left, int row) {
        using enum Line;
        const auto later = [&](const auto& edge) { return edge.first_row > row; };
        const auto starting = std::find_if(first_left, lists.edges.end(), later);
        for (auto edge = first_left; edge != starting; ++edge) {
            if (edge->last_row < edge->first_row) continue;
            if (!edge->level()) {
                lists.active_edges.push_back(entry_of(run, polygon, *edge));
                run.trace.ael_add(Z8, lists.active_edges.back());
            } else {
                run.trace.horizontal(Z9, *edge);
                run.show_line(Z9, row, edge->upper, edge->lower, polygon);
            }
        }
        const int next_start = starting == lists.edges.end() ? no_row : starting->first_row;
        run.trace.leave(Z10, Part{first_left, starting}, next_start);
        first_left = starting;
        return next_start;
    }

    /// Z11 and Z12: AEL from left to right. Gives the first row that one of its edges no longer reaches.
    template <class Run>
    static int sort_active_edges(Run& run, auto& active_edges, int row) {
        using enum Line;
        insertion_sort(active_edges, [&](const auto& a, const auto& b) { return run.kernel.left_of(a, b, row); });
        const int next_end = first_end(active_edges);
        run.trace.ael_sort(Z12, active_edges, next_end);
        return next_end;
    }

    /// Z15 and Z16: the edges that do not reach the row leave AEL. Gives the first row that another no longer reaches.
    template <class Run>
    static int drop_ended(Run& run, auto& active_edges, int row) {
        using enum Line;
        const auto stays = [&](const auto& edge) { return edge.last_row >= row; };
        insertion_sort(active_edges, [&](const auto& a, const auto& b) { return stays(a) && !stays(b); });
        const auto ended = std::find_if_not(active_edges.begin(), active_edges.end(), stays);
        const int next_end = first_end(Part{active_edges.begin(), ended});
        run.trace.ael_drop(Z16, Part{ended, active_edges.end()}, next_end);
        active_edges.erase(ended, active_edges.end());
        return next_end;
    }

    /// S: the edges by increasing y1; the depth of a vertex is that of the plane.
    template <class Run>
    static void sort_edges(Run& run, const Polygon<typename Run::Arithmetic>& polygon,
                           EdgeLists<typename Run::Arithmetic>& lists) {
        using enum Line;
        auto& [vertices, edges, active_edges] = lists;
        vertices.clear();
        edges.clear();
        for (const auto& vertex : polygon.vertices) {
            vertices.push_back({vertex.x, vertex.y, run.kernel.finite(run.depth(Z3, polygon, vertex))});
        }
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto& next = vertices[(i + 1) % vertices.size()];
            edges.push_back(edge_between(run, polygon, int(i), vertices[i], next));
        }
        const auto above = [](const auto& a, const auto& b) { return a.upper.y < b.upper.y; };
        insertion_sort(edges, above);
        for (const auto& edge : edges) run.trace.edge(Z3, edge);
    }
};

}  // namespace vidno
