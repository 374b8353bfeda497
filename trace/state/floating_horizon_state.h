/// FloatingHorizonState: everything that a run of curves holds at a step, rebuilt from its events alone. State is the equivalent for
/// polygons.
#pragma once

#include "format/floating_horizon_trace.h"
#include "state/call_stack.h"

namespace vidno {

class FloatingHorizonState {
public:
    using Heights = std::vector<std::optional<Value>>;  // over each column of the area

    /// A column that was examined, and the result of Visibility.
    struct Looked {
        int x;
        VisibilityFlag flag;
        bool operator==(const Looked&) const = default;
    };

    explicit FloatingHorizonState(const FloatingHorizonHeader& header);

    /// Takes the next event. If it throws Impossible, discard the state, which may be inconsistent.
    void apply(const EventView& event);

    std::uint64_t step() const { return step_; }
    const FloatingHorizonHeader& header() const { return *header_; }
    const std::vector<CallStack::Frame>& calls() const { return calls_.frames(); }
    const DrawnLines& lines() const { return lines_; }
    std::optional<int> curve() const { return curve_; }                        // the current one
    const std::optional<SegmentColumns>& segment() const { return segment_; }  // of that curve

    // From level `polygons` on; below it there are no horizons, edges and columns.
    const Heights& upper() const { return upper_; }
    const Heights& lower() const { return lower_; }
    const std::optional<SampleTold>& left_edge() const { return left_edge_; }
    const std::optional<SampleTold>& right_edge() const { return right_edge_; }
    const std::optional<Looked>& previous() const { return previous_; }  // x and Pflag
    const std::optional<Looked>& current() const { return current_; }    // x' and Tflag

private:
    void take(const event::Call&) {}
    void take(const event::Disagree&) {}
    void take(const event::Horizons&);
    void take(const event::Curve&);
    void take(const event::SideEdge&);
    void take(const event::Visibility&);
    void take(const event::Intersection&) {}
    void take(const event::DrawLine&);
    void take(const event::Horizon&);
    void take(const event::Height&) {}
    void take(const event::Raise& e) { set(upper_, e.x, e.y); }
    void take(const event::Lower& e) { set(lower_, e.x, e.y); }
    void take(const event::Step&) {}
    template <class E>
    void take(const E&) requires(!FloatingHorizonEvent<E>) {
        throw Impossible{"an event of a run of polygons"};
    }

    /// The index of a column of the area.
    std::size_t column(int x) const;
    void set(Heights& horizon, int x, const Value& y) const;
    Segment segment_on(const SegmentColumns& columns) const;
    LineEnd<Value> end_of(const ValuePoint& point, const std::pair<int, int>& columns) const;

    const FloatingHorizonHeader* header_;
    std::uint64_t step_ = 0;
    CallStack calls_;
    DrawnLines lines_;
    std::optional<int> curve_;
    Heights upper_, lower_;
    std::optional<SampleTold> left_edge_, right_edge_;
    std::optional<SegmentColumns> segment_;
    std::optional<Looked> previous_, current_;
};

/// The state as JSON on one line.
std::string state_json(const FloatingHorizonState& state);

}  // namespace vidno
