#include <cmath>
#include <set>
#include <tuple>

#include "choice/algorithm.h"
#include "notation.h"
#include "parts.h"
#include "weiler_atherton_parts.h"

namespace vidno::figures {

namespace {

constexpr double least_side = 0.5;  // millimetres: smaller windows look the same

Path outlined(std::vector<Polyline> lines, Stroke stroke) { return {std::move(lines), false, {}, std::move(stroke)}; }

std::vector<Polyline> cut(const Plane& plane, const Window& window) {
    return clipped(plane.box(window).corners(), true, plane.shown);
}

/// Drawn slightly smaller, so that neighbours can be distinguished.
Box shrunk(const Box& box) {
    const double by = std::min(0.5, 0.15 * box.width);
    return {box.x + by, box.y + by, box.width - 2 * by, box.height - 2 * by};
}

/// Each window once, however often it was visited.
std::vector<Polyline> visited_windows(const Moment& moment, const Plane& plane) {
    std::set<std::tuple<double, double, double, double>> seen;
    std::vector<Polyline> lines;
    for (const auto& window : moment.visited()) {
        if (std::min(window.width, window.height) * plane.scale < least_side) continue;
        if (!seen.emplace(window.x, window.y, window.width, window.height).second) continue;
        for (auto& line : cut(plane, window)) lines.push_back(std::move(line));
    }
    return lines;
}

void draw_quadtree(Drawing& to, const Moment& moment, const Plane& plane) {
    draw_visited(to, moment, plane);
    std::vector<Polyline> stacked;
    for (const auto& [window, list] : moment.state().warnock().stack()) {
        for (auto& line : clipped(shrunk(plane.box(window)).corners(), true, plane.shown)) {
            stacked.push_back(std::move(line));
        }
    }
    to.add(outlined(std::move(stacked), {Color{0x4a, 0x52, 0x60}, 0.4, {0.8, 1.4}}));
    if (const auto& current = moment.state().warnock().current())
        add_rimmed(to, outlined(cut(plane, current->window), {ink, 1}));
}

void draw_scanline(Drawing& to, const Moment& moment, const Plane& plane) {
    const State& state = moment.state();
    if (const auto row = state.z_buffer().last().row) {
        const Box box = plane.box(plane.area.x, *row, plane.area.width, 1);
        to.add(outlined(clipped(box.corners(), true, plane.shown), {ink, 0.5}));
    }
    const auto polygon = state.z_buffer().polygon();
    if (!polygon) return;
    const auto& vertices = moment.scene().polygons[std::size_t(polygon->index)].vertices;
    std::vector<Polyline> edges;
    for (const auto& entry : state.z_buffer().active_edges()) {
        const auto& a = vertices[std::size_t(entry.edge) % vertices.size()];
        const auto& b = vertices[(std::size_t(entry.edge) + 1) % vertices.size()];
        for (auto& line : clipped({plane.at(a.x, a.y), plane.at(b.x, b.y)}, false, plane.shown)) {
            edges.push_back(std::move(line));
        }
    }
    add_rimmed(to, outlined(std::move(edges), {ink, 1}));
}

}  // namespace

void draw_visited(Drawing& to, const Moment& moment, const Plane& plane) {
    to.add(outlined(visited_windows(moment, plane), {ink, Stroke::hairline}));
}

void draw_chosen(Drawing& to, Pixel pixel, const Plane& plane) {
    constexpr double reach = 1.6;
    const Box box = plane.box(pixel.x, pixel.y, 1, 1);
    const Point middle{box.x + box.width / 2, box.y + box.height / 2};
    const auto corners = box.corners();
    std::vector<Polyline> lines{{corners[0], corners[1], corners[2], corners[3], corners[0]},
                                {{box.x - reach, middle.y}, {box.x, middle.y}},
                                {{box.right(), middle.y}, {box.right() + reach, middle.y}},
                                {{middle.x, box.y - reach}, {middle.x, box.y}},
                                {{middle.x, box.bottom()}, {middle.x, box.bottom() + reach}}};
    add_rimmed(to, outlined(std::move(lines), {ink, 1}));
}

void draw_windows(Drawing& to, const Moment& moment, const Plane& plane, const Style& style) {
    switch (algorithm_of(moment.header().method)) {
        case Algorithm::warnock: return draw_quadtree(to, moment, plane);
        case Algorithm::z_buffer: return draw_scanline(to, moment, plane);
        case Algorithm::weiler_atherton: return draw_lists(to, moment, plane, style);
    }
}

}  // namespace vidno::figures
