/// WarnockState: what Warnock's algorithm and its variants hold at a step.
#pragma once

#include <map>

#include "format/event_fields.h"
#include "replay/polygon_list.h"
#include "replay/screen.h"

namespace vidno {

class WarnockState {
public:
    using Events = decltype(EventsOfAll{} + WarnockEvents{} + FamilyEvents{});
    /// The events that it keeps.
    using Kept = EventTypes<event::Ray, event::Octants>;

    struct StackedWindow {
        Window window;
        int list = 0;  // below level `polygons`, polygons never leave it
        bool operator==(const StackedWindow&) const = default;
        static void fields(auto& stacked, auto&& field) {
            field("window", stacked.window);
            field("list", stacked.list);
        }
    };
    /// A polygon that surrounds a window or lies outside it, with the level of the window at which it joined that list.
    struct Joined {
        PolygonPlace polygon;
        int level = 0;
        bool operator==(const Joined&) const = default;
        static void fields(auto& joined, auto&& field) {
            field("polygon", joined.polygon);
            field("level", joined.level);
        }
    };
    /// With three lists the APL, which all windows share, is the third; these are the other two.
    struct OtherLists {
        std::vector<Joined> surrounding, outside;
        bool operator==(const OtherLists&) const = default;
        static void fields(auto& lists, auto&& field) {
            field("surrounding", lists.surrounding);
            field("outside", lists.outside);
        }
    };
    struct Clip {
        std::vector<ValueVertex> vertices, next;
        bool operator==(const Clip&) const = default;
        static void fields(auto& clip, auto&& field) {
            field("vertices", clip.vertices);
            field("next", clip.next);
        }
    };
    struct Nearest {
        PolygonPlace polygon;
        Value z;
        bool operator==(const Nearest&) const = default;
        static void fields(auto& nearest, auto&& field) {
            field("polygon", nearest.polygon);
            field("z", nearest.z);
        }
    };
    struct CornerDepths {
        std::array<Value, 4> of;  // by Corner
        bool operator==(const CornerDepths&) const = default;
        static void fields(auto& depths, auto&& field) {
            for (std::size_t i = 0; i < corner_names.size(); ++i) field(corner_names[i], depths.of[i]);
        }
    };

    /// What was found about a window.
    struct Findings {
        std::optional<CornerDepths> corners;
        std::optional<int> k, count;
        std::optional<bool> has_surround;
        std::optional<Color> color;
        std::optional<bool> insider;
        bool operator==(const Findings&) const = default;
        static void fields(auto& found, auto&& field) {
            field("corners", found.corners);
            field("k", found.k);
            field("count", found.count);
            field("hasSurround", found.has_surround);
            field("color", found.color);
            field("insider", found.insider);
        }
    };

    explicit WarnockState(const TraceHeader& header) : scene_(&header.scene) {
        last_.count = 0;
        last_.has_surround = false;
        last_.insider = false;
    }

    /// The first window, which contains all others.
    const std::optional<Window>& root() const { return root_; }
    /// The windows that were split on the way to the current one; their number is its level.
    const std::vector<Window>& way() const { return way_; }
    const std::vector<StackedWindow>& stack() const { return stack_; }  // AW, bottom first
    const std::optional<StackedWindow>& current() const { return current_; }
    const std::map<int, PolygonList>& lists() const { return lists_; }
    const PolygonList& list(const StackedWindow& window) const { return lists_.at(window.list); }
    const OtherLists& joined() const { return joined_; }
    /// About the current window.
    const Findings& found() const { return found_; }
    /// What the program's variables hold: they keep a finding until it is set again, perhaps in another window.
    const Findings& last() const { return last_; }
    /// The polygon that surrounds the window and hides all others so far.
    std::optional<PolygonPlace> covering() const { return covering_; }
    /// The polygon that did so until the last event Uncover.
    std::optional<PolygonPlace> uncovered() const { return uncovered_; }
    const std::optional<Clip>& clip() const { return clip_; }
    /// The side of the window by which PolygonClip clips.
    const std::optional<event::ClipSide>& clip_side() const { return clip_side_; }
    /// The depths of the current polygon at the corners so far.
    const std::vector<Value>& depths() const { return depths_; }
    /// What PointColor has found so far.
    const std::optional<Nearest>& nearest() const { return nearest_; }
    /// The edges of the outline that a test of containment has counted so far.
    const std::vector<Event>& contained() const { return contained_; }

    /// The names that the page uses. The lists are written separately, since windows share them.
    static void fields(auto& state, auto&& field) {
        field("root", state.root_);
        field("way", state.way_);
        field("stack", state.stack_);
        field("current", state.current_);
        field("joined", state.joined_);
        Findings::fields(state.found_, field);
        field("last", state.last_);
        field("covering", state.covering_);
        field("clip", state.clip_);
        field("depths", state.depths_);
        field("nearest", state.nearest_);
        field("contained", state.contained_);
    }

    void take(const event::Depth&, Screen&);
    void take(const event::Push&, Screen&);
    void take(const event::Pop&, Screen&);
    void take(const event::Fill& e, Screen& screen) { screen.paint(e.rect, e.color); }
    void take(const event::Corners&, Screen&);
    void take(const event::Discard& e, Screen&) { current_list().remove(e.polygon); }
    void take(const event::Count&, Screen&);
    void take(const event::Nearer&, Screen&);
    void take(const event::Uncover&, Screen&);
    void take(const event::Mark& e, Screen&) { current_list().mark(e.polygon); }
    void take(const event::Cover&, Screen&);
    void take(const event::Insider&, Screen&);
    void take(const event::Summary&, Screen&);
    void take(const event::Nearest& e, Screen&) { nearest_ = {e.polygon, e.z}; }
    void take(const event::PointColor&, Screen&);
    void take(const event::ClipBegin&, Screen&);
    void take(const event::ClipSide& e, Screen&) {
        clipping().next.clear();
        clip_side_ = e;
    }
    void take(const event::ClipCross& e, Screen&) { clipping().next.push_back(e.vertex); }
    void take(const event::ClipKeep& e, Screen&) { clipping().next.push_back(e.vertex); }
    void take(const event::ClipList&, Screen&);
    void take(const event::ClipResult&, Screen&) { clip_.reset(); }
    void take(const event::Draw&, Screen&);
    void take(const event::Join&, Screen&);
    void take(const event::Rejoin&, Screen&);
    void take(const event::RelationFound&, Screen&) { contained_.clear(); }
    void take(const event::Meets&, Screen&) { contained_.clear(); }
    void take(const event::Ray& e, Screen&) { contained_.emplace_back(e); }
    void take(const event::Octants& e, Screen&) { contained_.emplace_back(e); }
    void take(const event::Hiding&, Screen&);

private:
    PolygonList& current_list();
    std::vector<Joined>& list_of(OtherList list) {
        return list == OtherList::surrounding ? joined_.surrounding : joined_.outside;
    }
    Clip& clipping();
    /// Sets a finding about the window, and the program's variable.
    void set(auto finding, const auto& value) {
        found_.*finding = value;
        last_.*finding = value;
    }

    const Scene* scene_;
    std::optional<Window> root_;
    std::vector<Window> way_;
    std::vector<StackedWindow> stack_;
    std::optional<StackedWindow> current_;
    std::map<int, PolygonList> lists_;  // of the windows on the stack and of the current one
    int next_list_ = 0;
    OtherLists joined_;
    Findings found_, last_;
    std::optional<PolygonPlace> covering_, uncovered_;
    std::optional<Clip> clip_;
    std::optional<event::ClipSide> clip_side_;
    std::vector<Value> depths_;
    bool are_depths_compared_ = false;
    std::optional<Nearest> nearest_;
    std::vector<Event> contained_;
};

}  // namespace vidno
