/// ZBufferState: what the Z-buffer's procedures hold at a step, besides the depths of the pixels.
#pragma once

#include "replay/screen.h"

namespace vidno {

class ZBufferState {
public:
    using Events = decltype(EventsOfAll{} + ZBufferEvents{});

    struct ActiveEdge {
        int edge;
        Value x, z, until, dx, dz;
        bool operator==(const ActiveEdge&) const = default;
        static void fields(auto& entry, auto&& field) {
            field("edge", entry.edge);
            field("x", entry.x);
            field("z", entry.z);
            field("until", entry.until);
            field("dx", entry.dx);
            field("dz", entry.dz);
        }
    };
    /// How far the scan of a polygon has come.
    struct Scan {
        std::optional<Value> y;
        std::optional<int> row;
        std::optional<Value> next_start,
            next_end;  // the rows at which the next edge of S begins, and the first of AEL has ended
        bool operator==(const Scan&) const = default;
        static void fields(auto& scan, auto&& field) {
            field("y", scan.y);
            field("row", scan.row);
            field("nextS", scan.next_start);
            field("nextAel", scan.next_end);
        }
    };

    explicit ZBufferState(const TraceHeader& header) : scene_(&header.scene) {}

    std::optional<PolygonPlace> polygon() const { return polygon_; }
    const std::vector<int>& edges() const { return edges_; }  // S
    const std::vector<ActiveEdge>& active_edges() const { return active_edges_; }
    /// That of the current polygon.
    const Scan& scan() const { return scan_; }
    /// What the program's variables hold: they keep a value until it is set again, perhaps for another polygon.
    const Scan& last() const { return last_; }

    /// The names that the page uses.
    static void fields(auto& state, auto&& field) {
        field("polygon", state.polygon_);
        field("edges", state.edges_);
        field("ael", state.active_edges_);
        Scan::fields(state.scan_, field);
        field("last", state.last_);
    }

    void take(const event::Clear& e, Screen& screen) { screen.clear(e.color, e.z); }
    void take(const event::Polygon&, Screen&);
    void take(const event::Edge& e, Screen&) { edges_.push_back(e.edge); }
    void take(const event::Scanline&, Screen&);
    void take(const event::AelAdd&, Screen&);
    void take(const event::Leave&, Screen&);
    void take(const event::AelSort&, Screen&);
    void take(const event::AelDrop&, Screen&);
    void take(const event::AelStep&, Screen&);
    void take(const event::Span&, Screen&);

private:
    std::vector<ActiveEdge>::iterator place_of(int edge);  // the end if it is not there
    ActiveEdge& active_edge(int edge);
    void set(auto progress, const auto& value) {
        scan_.*progress = value;
        last_.*progress = value;
    }

    const Scene* scene_;
    std::optional<PolygonPlace> polygon_;
    std::vector<int> edges_;
    std::vector<ActiveEdge> active_edges_;
    Scan scan_, last_;
};

}  // namespace vidno
