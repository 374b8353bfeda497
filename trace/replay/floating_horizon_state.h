/// FloatingHorizonState: everything that a run of curves holds at a step, rebuilt from its events alone. State is the
/// equivalent for polygons.
#pragma once

#include "format/floating_horizon_trace.h"
#include "replay/call_stack.h"

namespace vidno {

class FloatingHorizonState {
public:
    using Events = decltype(EventTypes<event::Call, event::Disagree>{} + FloatingHorizonEvents{});
    /// The event that it keeps.
    using Kept = EventTypes<event::Height>;

    using Heights = std::vector<std::optional<Value>>;  // over each column of the area
    struct Horizons {
        Heights upper, lower;
        bool operator==(const Horizons&) const = default;
        static void fields(auto& horizons, auto&& field) {
            field("upper", horizons.upper);
            field("lower", horizons.lower);
        }
    };

    /// A column that was examined, and the result of Visibility.
    using Looked = std::pair<int, VisibilityFlag>;
    /// The part of the current curve that was examined last.
    struct Place {
        std::optional<SegmentColumns> segment;
        std::optional<Looked> previous, current;  // x and Pflag, x' and Tflag
        bool operator==(const Place&) const = default;
        static void fields(auto& place, auto&& field) {
            field("segment", place.segment);
            field("previous", place.previous);
            field("current", place.current);
        }
    };
    /// The points that the side edges have reached.
    struct SideEdges {
        std::optional<ReportedSample> left, right;
        bool operator==(const SideEdges&) const = default;
        static void fields(auto& edges, auto&& field) {
            field("left", edges.left);
            field("right", edges.right);
        }
    };

    struct Values {
        CallStack calls{Procedure::floating_horizon, Detail::windows};
        DrawnLines lines{};
        std::optional<int> curve{};  // the current one
        Place place{};
        SideEdges edges{};
        // From level `polygons` on; below it there are no horizons and flags.
        Horizons horizons{};
        /// Those at the start of the current curve, which the curve is compared with, except in the printed text.
        Horizons before{};
        /// The results of Visibility for the current curve, over each column.
        std::vector<std::optional<VisibilityFlag>> flags{};
        /// The last event Height, if the trace has it.
        std::optional<Event> height{};

        /// The names that the page uses. Calls and lines are written separately.
        static void fields(auto& values, auto&& field) {
            field("curve", values.curve);
            field("place", values.place);
            field("edges", values.edges);
            field("horizons", values.horizons);
            field("before", values.before);
            field("flags", values.flags);
            field("height", values.height);
        }
    };

    /// The header must outlive the state.
    explicit FloatingHorizonState(const FloatingHorizonHeader& header);

    /// Takes the next event. If it throws Impossible, discard the state, which may be inconsistent.
    void apply(const EventView& event);

    std::uint64_t step() const { return step_; }
    const FloatingHorizonHeader& header() const { return *header_; }
    const Values& values() const { return values_; }
    const std::vector<CallStack::Frame>& calls() const { return values_.calls.frames(); }

private:
    void take(const event::Horizons&);
    void take(const event::Curve&);
    void take(const event::SideEdge& e) { (e.at == Line::FH3 ? values_.edges.left : values_.edges.right) = e.sample; }
    void take(const event::Visibility&);
    void take(const event::DrawLine&);
    void take(const event::Horizon&);
    void take(const event::Height& e) { values_.height = e; }
    void take(const event::Raise& e) { values_.horizons.upper[column(e.x)] = e.y; }
    void take(const event::Lower& e) { values_.horizons.lower[column(e.x)] = e.y; }

    /// The index of a column of the area.
    std::size_t column(int x) const;
    Segment segment_on(const SegmentColumns& columns) const;

    const FloatingHorizonHeader* header_;
    std::uint64_t step_ = 0;
    Values values_;
};

/// The state as JSON on one line.
std::string state_json(const FloatingHorizonState& state);

}  // namespace vidno
