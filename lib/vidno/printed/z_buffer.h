/// ZBuffer as printed: y_t and the lists are numbers, not rows.
///
/// X-Z1  edges enter by rounded y but leave by unrounded y: AEL may hold three entries, and the pairs misalign.
/// X-Z6  y_t starts at a fractional ymin, and where the numbers are coarse y_t + 1 = y_t.
/// X-Z7  Z starts at -1.
/// X-Z8  the least element of an empty list is undefined; here it is plus infinity: there is no next one.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>

#include "../fault.h"
#include "../part.h"
#include "../run.h"
#include "show_line.h"

namespace vidno::printed {

/// An edge from its upper end to its lower one; a level edge goes from left to right.
template <class Number>
struct PolygonEdge {
    int index;
    Vertex<Number> upper, lower;
};

/// (x1, z1, y2, dx/dy, dz/dy).
template <class Number>
struct ActiveEdge {
    int index;
    Number x, z, until, dx, dz;
};

/// More scanlines or steps than the largest area has rows and pixels: the loop makes no progress.
inline constexpr int step_limit = 1 << 20;

struct ZBuffer {
    template <class Run>
    static void z_buffer(Run& run) {
        using enum Line;
        const auto start = run.kernel.depth_of(-1);
        run.depth_buffer.clear(run.area, start);
        run.trace.clear(Z1, run.background, start);
        for (const auto& polygon : run.polygons) {
            run.trace.polygon(Z2, polygon);
            scan_polygon(run, polygon);
        }
    }

private:
    template <class Run>
    static void scan_polygon(Run& run, const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        using Number = typename Run::Number;
        auto& kernel = run.kernel;
        auto& trace = run.trace;

        auto edges = sorted_edges(run, polygon);  // S
        trace.extent(Z4, polygon.box.ymin, polygon.box.ymax);
        std::vector<ActiveEdge<Number>> active_edges;  // AEL
        Number y = polygon.box.ymin;
        std::optional<Number> next_start = y;
        std::optional<Number> next_end;
        for (int steps = 0; y <= polygon.box.ymax; ++steps) {
            if (steps == step_limit) throw Fault{Z15, "more scanlines than any area has rows"};
            trace.scanline(Z6, y, kernel.pixel_of(y));
            if (next_start && kernel.same_rounded(y, *next_start)) {
                const auto starts_here = [&](const auto& edge) { return kernel.same_rounded(edge.upper.y, y); };
                for (const auto& edge : edges) {
                    if (starts_here(edge)) start(run, edge, y, active_edges, polygon);
                }
                const auto starting = std::stable_partition(edges.begin(), edges.end(), std::not_fn(starts_here));
                next_start = least(Part{edges.begin(), starting}, [](const auto& edge) { return edge.upper.y; });
                trace.leave(Z10, Part{starting, edges.end()}, next_start);
                edges.erase(starting, edges.end());
                const auto left_of = [](const auto& a, const auto& b) {
                    return a.x < b.x || (a.x == b.x && a.dx < b.dx);
                };
                std::stable_sort(active_edges.begin(), active_edges.end(), left_of);
                next_end = least(active_edges, [](const auto& edge) { return edge.until; });
                trace.ael_sort(Z12, active_edges, next_end);
            }
            for (std::size_t i = 0; i < active_edges.size(); i += 2) {
                if (i + 1 == active_edges.size()) throw Fault{Z14, "the last entry of AEL has no partner"};
                const auto& left = active_edges[i];
                const auto& right = active_edges[i + 1];
                run.show_line(Z14, y, SpanEnd<Number>{left.x, left.z}, SpanEnd<Number>{right.x, right.z}, polygon);
            }
            y += 1;
            if (next_end && y >= *next_end) {
                const auto stays = [&](const auto& edge) { return !(edge.until <= y); };
                const auto ended = std::stable_partition(active_edges.begin(), active_edges.end(), stays);
                next_end = least(Part{active_edges.begin(), ended}, [](const auto& edge) { return edge.until; });
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

    /// An edge that begins on the scanline enters AEL; a level one is shown at once.
    template <class Run>
    static void start(Run& run, const auto& edge, const auto& y, auto& active_edges, const auto& polygon) {
        using Number = typename Run::Number;
        const auto& [x1, y1, z1] = edge.upper;
        const auto& [x2, y2, z2] = edge.lower;
        if (run.kernel.same_rounded(y1, y2)) {
            run.trace.horizontal(Line::Z9, edge);
            run.show_line(Line::Z9, y, SpanEnd<Number>{x1, z1}, SpanEnd<Number>{x2, z2}, polygon);
            return;
        }
        const Number height = y2 - y1;
        const Number dx = (x2 - x1) / height;
        const Number dz = (z2 - z1) / height;
        active_edges.push_back({edge.index, x1, z1, y2, dx, dz});
        run.trace.ael_add(Line::Z8, active_edges.back());
    }

    template <class Run>
    static auto sorted_edges(Run& run, const Polygon<typename Run::Arithmetic>& polygon) {
        std::vector<PolygonEdge<typename Run::Number>> edges;
        const auto& vertices = polygon.vertices;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            auto upper = vertices[i];
            auto lower = vertices[(i + 1) % vertices.size()];
            const bool level = run.kernel.same_rounded(upper.y, lower.y);
            if (level ? lower.x < upper.x : lower.y < upper.y) std::swap(upper, lower);
            edges.push_back({int(i), upper, lower});
        }
        const auto above = [](const auto& a, const auto& b) { return a.upper.y < b.upper.y; };
        std::stable_sort(edges.begin(), edges.end(), above);
        for (const auto& edge : edges) run.trace.edge(Line::Z3, edge);
        return edges;
    }

    static auto least(const auto& edges, auto value_of) -> std::optional<decltype(value_of(*edges.begin()))> {
        std::optional<decltype(value_of(*edges.begin()))> found;
        for (const auto& edge : edges) {
            if (!found || value_of(edge) < *found) found = value_of(edge);
        }
        return found;
    }
};

}  // namespace vidno::printed
