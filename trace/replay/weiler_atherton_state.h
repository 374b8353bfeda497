/// WeilerAthertonState: what Weiler and Atherton's algorithm holds at a step.
#pragma once

#include <memory>

#include "replay/screen.h"

namespace vidno {

class WeilerAthertonState {
public:
    using Events = decltype(EventsOfAll{} + WeilerAthertonEvents{} + EventTypes<event::Row>{});
    /// The event that it keeps.
    using Kept = EventTypes<event::Pierce>;

    /// A part of a polygon. States share it, because it may have many corners and does not change.
    using Piece = std::shared_ptr<const PolygonPart>;
    using Pieces = std::vector<Piece>;

    /// WA4: the current list, taken from the stack.
    struct CurrentList {
        Pieces pieces;             // the first is the clip polygon
        int seen = 1;              // how many were processed so far, the clip polygon included
        Pieces inside, outside;    // of its outline, from level `polygons`
        std::vector<bool> behind;  // for the parts inside that are not ground, in order
        bool operator==(const CurrentList&) const = default;
        static void fields(auto& list, auto&& field) {
            field("pieces", list.pieces);
            field("seen", list.seen);
            field("inside", list.inside);
            field("outside", list.outside);
            field("behind", list.behind);
        }
    };
    /// Where the outline of the region that is being clipped enters and leaves the clip region, as far as it was found.
    struct Crossings {
        std::vector<ValuePoint> entering, leaving;
        bool operator==(const Crossings&) const = default;
        static void fields(auto& crossings, auto&& field) {
            field("entering", crossings.entering);
            field("leaving", crossings.leaving);
        }
    };

    explicit WeilerAthertonState(const TraceHeader&) {}

    const std::vector<Pieces>& lists() const { return lists_; }  // the stack, bottom first
    const std::optional<CurrentList>& current_list() const { return current_list_; }
    const Pieces& facets() const { return facets_; }
    const Pieces& visible() const { return visible_; }
    const Crossings& crossings() const { return crossings_; }
    /// The event Pierce of the two polygons that are being split.
    const std::optional<Event>& piercing() const { return piercing_; }

    /// The names that the page uses.
    static void fields(auto& state, auto&& field) {
        field("lists", state.lists_);
        field("currentList", state.current_list_);
        field("facets", state.facets_);
        field("visible", state.visible_);
        field("crossings", state.crossings_);
        field("piercing", state.piercing_);
    }

    void take(const event::CutToArea&, Screen&);
    void take(const event::Pierce& e, Screen&) { piercing_ = e; }
    void take(const event::Facets&, Screen&);
    void take(const event::PushList& e, Screen&) { lists_.push_back(shared(e.pieces)); }
    void take(const event::PopList&, Screen&);
    void take(const event::Beside&, Screen&);
    void take(const event::Clipped&, Screen&);
    void take(const event::Entering& e, Screen&) { crossings_.entering.push_back(e.point); }
    void take(const event::Leaving& e, Screen&) { crossings_.leaving.push_back(e.point); }
    void take(const event::Behind& e, Screen&) { list_to_change().behind.push_back(e.behind); }
    void take(const event::NearerOnes&, Screen&);
    void take(const event::Show& e, Screen&) { visible_.push_back(shared({e.polygon, e.region})); }
    void take(const event::Paint&, Screen&);
    void take(const event::Painted&, Screen& screen) { screen.finish_ground(); }

private:
    static Piece shared(PolygonPart part) { return std::make_shared<const PolygonPart>(std::move(part)); }
    static Pieces shared(const std::vector<PolygonPart>& parts);
    CurrentList& list_to_change();
    const Piece& next_piece(CurrentList& list, PolygonPlace polygon) const;

    std::vector<Pieces> lists_;
    std::optional<CurrentList> current_list_;
    Pieces facets_, visible_;
    Crossings crossings_;
    std::optional<Event> piercing_;
};

}  // namespace vidno
