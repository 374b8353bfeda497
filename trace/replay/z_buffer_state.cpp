#include "replay/z_buffer_state.h"

#include <algorithm>
#include <set>

namespace vidno {

void ZBufferState::take(const event::Polygon& e, Screen&) {
    polygon_ = e.polygon;
    edges_.clear();
    active_edges_.clear();
    scan_ = {};
}

void ZBufferState::take(const event::Scanline& e, Screen&) {
    set(&Scan::y, e.y);
    set(&Scan::row, e.row);
}

void ZBufferState::take(const event::AelAdd& e, Screen&) {
    if (place_of(e.edge) != active_edges_.end()) throw Impossible{"an edge that is already in AEL"};
    active_edges_.push_back({e.edge, e.x, e.z, e.until, e.dx, e.dz});
}

void ZBufferState::take(const event::Leave& e, Screen&) {
    const auto is_in = [](int edge, const std::vector<int>& edges) {
        return std::find(edges.begin(), edges.end(), edge) != edges.end();
    };
    for (const int edge : e.edges) {
        if (!is_in(edge, edges_)) throw Impossible{"an edge that is not in S"};
    }
    std::erase_if(edges_, [&](int edge) { return is_in(edge, e.edges); });
    set(&Scan::next_start, e.next);
}

std::vector<ZBufferState::ActiveEdge>::iterator ZBufferState::place_of(int edge) {
    return std::find_if(active_edges_.begin(), active_edges_.end(),
                        [&](const ActiveEdge& entry) { return entry.edge == edge; });
}

ZBufferState::ActiveEdge& ZBufferState::active_edge(int edge) {
    const auto found = place_of(edge);
    if (found == active_edges_.end()) throw Impossible{"an edge that is not in AEL"};
    return *found;
}

void ZBufferState::take(const event::AelSort& e, Screen&) {
    std::vector<ActiveEdge> sorted;
    for (const int edge : e.edges) sorted.push_back(active_edge(edge));
    const std::set<int> edges(e.edges.begin(), e.edges.end());
    if (edges.size() != active_edges_.size() || sorted.size() != active_edges_.size()) {
        throw Impossible{"an order of entries that are not those of AEL"};
    }
    active_edges_ = std::move(sorted);
    set(&Scan::next_end, e.next);
}

void ZBufferState::take(const event::AelDrop& e, Screen&) {
    for (const int edge : e.edges) {
        active_edges_.erase(active_edges_.begin() + (&active_edge(edge) - active_edges_.data()));
    }
    set(&Scan::next_end, e.next);
}

void ZBufferState::take(const event::AelStep& e, Screen&) {
    ActiveEdge& entry = active_edge(e.edge);
    entry.x = e.x;
    entry.z = e.z;
}

void ZBufferState::take(const event::Span& e, Screen& screen) {
    if (!polygon_) throw Impossible{"a span of no polygon"};
    std::int64_t pixels = 0;
    for (const auto& [first, end] : e.runs) pixels += std::int64_t{end} - first;
    if (e.depths && std::int64_t(e.depths->size()) != pixels) throw Impossible{"not one depth for each pixel"};
    const Color& color = scene_->polygons[std::size_t(polygon_->index)].color;
    std::size_t next = 0;
    for (const auto& [first, end] : e.runs) {
        screen.paint(PixelRun{e.row, first, end}, color);
        if (!e.depths) continue;
        for (int x = first; x < end; ++x) screen.store_depth(x, e.row, (*e.depths)[next++]);
    }
}

}  // namespace vidno
