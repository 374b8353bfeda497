/// State: everything that a method holds at a step, rebuilt from its events alone.
#pragma once

#include <memory>
#include <unordered_map>

#include "format/trace_writer.h"
#include "state/call_stack.h"

namespace vidno {

class State {
public:
    using Apl = std::vector<AplEntry>;

    using Frame = CallStack::Frame;
    struct StackedWindow {
        Window window;
        std::shared_ptr<Apl> apl;  // below level `polygons`, polygons never leave it
    };
    /// An entry of the list of surrounding or outside polygons, which it joined at a window of this level.
    struct Joined {
        PolygonPlace polygon;
        int level;
    };
    struct Clip {
        std::vector<ValueVertex> vertices, next;
    };
    /// WA4: the current list, taken from the stack.
    struct ListInHand {
        std::vector<PolygonPart> pieces;           // the first is the clip polygon
        std::vector<PolygonPart> inside, outside;  // of its outline, from level `polygons`
    };
    struct AelEntry {
        int edge;
        Value x, z, until, dx, dz;
    };

    explicit State(const TraceHeader& header);

    /// Takes the next event. If it throws Impossible, discard the state, which may be inconsistent.
    void apply(const EventView& event);

    std::uint64_t step() const { return step_; }
    const TraceHeader& header() const { return *header_; }
    const Picture& picture() const { return picture_; }
    const std::vector<Frame>& calls() const { return calls_.frames(); }

    // Warnock
    const std::vector<StackedWindow>& stack() const { return stack_; }  // AW, bottom first
    const std::optional<StackedWindow>& current() const { return current_; }
    const std::optional<std::array<Value, 4>>& corners() const { return corners_; }
    std::optional<int> k() const { return k_; }
    int count() const { return count_; }
    bool has_surround() const { return has_surround_; }
    const std::optional<Color>& color() const { return color_; }
    bool insider() const { return insider_; }
    const std::optional<Clip>& clip() const { return clip_; }
    /// With three lists the APL, which all windows share, is the third; these are the other two.
    const std::vector<Joined>& surrounding() const { return surrounding_; }
    const std::vector<Joined>& outside() const { return outside_; }

    // Weiler-Atherton
    const std::vector<std::vector<PolygonPart>>& lists() const { return lists_; }  // bottom first
    const std::optional<ListInHand>& list_in_hand() const { return list_in_hand_; }
    const std::vector<PolygonPart>& facets() const { return facets_; }
    const std::vector<PolygonPart>& visible() const { return visible_; }

    // Z-buffer
    std::optional<int> polygon() const { return polygon_; }
    const std::vector<int>& edges() const { return edges_; }  // S
    const std::vector<AelEntry>& ael() const { return ael_; }
    const std::optional<Value>& y() const { return y_; }
    std::optional<int> row() const { return row_; }
    const std::optional<Value>& next_start() const { return next_start_; }
    const std::optional<Value>& next_end() const { return next_end_; }
    /// The depth of a cell; none before Z1 and below level `polygons`.
    std::optional<Value> depth(int x, int y) const;

private:
    void take(const event::Plane&) {}
    void take(const event::Call&) {}
    void take(const event::Disagree&) {}
    void take(const event::Depth&);
    void take(const event::Fault&) {}
    void take(const event::Push&);
    void take(const event::Skip&) {}
    void take(const event::Pop&);
    void take(const event::Decide&) {}
    void take(const event::Fill&);
    void take(const event::Corners&);
    void take(const event::Box&) {}
    void take(const event::Discard&);
    void take(const event::Count&);
    void take(const event::Compare&) {}
    void take(const event::Nearer&);
    void take(const event::Uncover&) { has_surround_ = false; }
    void take(const event::Mark&);
    void take(const event::Cover&);
    void take(const event::Insider& e) { insider_ = e.inside; }
    void take(const event::Summary&);
    void take(const event::Nearest&) {}
    void take(const event::PointColor& e);
    void take(const event::Surround&) {}
    void take(const event::Orient&) {}
    void take(const event::ClipBegin&);
    void take(const event::ClipSide&) { clipping().next.clear(); }
    void take(const event::ClipSign&) {}
    void take(const event::ClipCross& e) { clipping().next.push_back(e.vertex); }
    void take(const event::ClipKeep& e) { clipping().next.push_back(e.vertex); }
    void take(const event::ClipDrop&) {}
    void take(const event::ClipList&);
    void take(const event::ClipResult&) { clip_.reset(); }
    void take(const event::Row&) {}
    void take(const event::Draw&);
    void take(const event::Clear&);
    void take(const event::Polygon&);
    void take(const event::Edge& e) { edges_.push_back(e.edge); }
    void take(const event::Extent&) {}
    void take(const event::Scanline&);
    void take(const event::AelAdd&);
    void take(const event::Horizontal&) {}
    void take(const event::Leave&);
    void take(const event::AelSort&);
    void take(const event::AelDrop&);
    void take(const event::AelStep&);
    void take(const event::ShownLine&) {}
    void take(const event::Miss&) {}
    void take(const event::Slope&) {}
    void take(const event::Columns&) {}
    void take(const event::Pixel&) {}
    void take(const event::Span&);
    void take(const event::Join&);
    void take(const event::Rejoin&);
    void take(const event::RelationFound&) {}
    void take(const event::Trial&) {}
    void take(const event::Meets&) {}
    void take(const event::Ray&) {}
    void take(const event::Crossings&) {}
    void take(const event::Octants&) {}
    void take(const event::Angle&) {}
    void take(const event::Hiding& e) { has_surround_ = e.polygon.has_value(); }
    void take(const event::SplitVertex&) {}
    void take(const event::EdgeDepth&) {}
    void take(const event::BackFace&) {}
    void take(const event::CutToArea&);
    void take(const event::Facets& e) { facets_ = e.pieces; }
    void take(const event::Sorted&) {}
    void take(const event::PushList& e) { lists_.push_back(e.pieces); }
    void take(const event::PopList&);
    void take(const event::Beside&);
    void take(const event::Clipped&);
    void take(const event::NearerOnes&);
    void take(const event::Show& e) { visible_.push_back({e.polygon, e.region}); }
    void take(const event::Pierce&) {}
    void take(const event::Split&) {}
    void take(const event::GreatestDepth&) {}
    void take(const event::EdgePiece&) {}
    void take(const event::Entering&) {}
    void take(const event::Leaving&) {}
    void take(const event::Behind&);
    void take(const event::Order&) {}
    void take(const event::Paint&);
    void take(const event::Painted&) {}
    void take(const FloatingHorizonEvent auto&) { throw Impossible{"an event of a run of curves"}; }

    Apl& current_apl();
    AplEntry& entry(PolygonPlace polygon);
    void remove_from_apl(PolygonPlace polygon);
    std::vector<Joined>& list_of(OtherList list);
    Clip& clipping();
    ListInHand& list_in_hand(PolygonPlace polygon);
    void paint(const std::vector<PixelRun>& runs, const Color& color);
    AelEntry& active_edge(int edge);
    void expect_in_area(const Window& window) const;
    void expect_in_area(int row, int first, int end) const;

    const TraceHeader* header_;
    std::uint64_t step_ = 0;
    Picture picture_;
    CallStack calls_;

    std::vector<StackedWindow> stack_;
    std::optional<StackedWindow> current_;
    std::vector<Value> depths_;  // at PW5, of the current polygon
    std::optional<std::array<Value, 4>> corners_;
    bool has_corners_ = false;  // those are of the current window
    std::optional<int> k_;
    int count_ = 0;
    bool has_surround_ = false;
    std::optional<Color> color_;
    bool insider_ = false;
    std::optional<Clip> clip_;
    std::vector<Joined> surrounding_, outside_;

    std::vector<std::vector<PolygonPart>> lists_;
    std::optional<ListInHand> list_in_hand_;
    std::size_t clipped_ = 0;   // the number of its pieces clipped so far
    std::vector<bool> behind_;  // for the parts inside that are not ground, in order
    std::vector<PolygonPart> facets_, visible_;

    std::optional<int> polygon_;
    std::vector<int> edges_;
    std::vector<AelEntry> ael_;
    std::optional<Value> y_;
    std::optional<int> row_;
    std::optional<Value> next_start_, next_end_;
    std::optional<Value> cleared_depth_;
    std::unordered_map<std::int64_t, Value> depths_stored_;  // of the cells that were written
};

/// The state as JSON on one line, as the page's tests compare it.
std::string state_json(const State& state);

}  // namespace vidno
