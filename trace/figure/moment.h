/// Moment: a step of a run with everything that a figure shows of it, rebuilt from the events alone.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "replay/state.h"

namespace vidno::figures {

class Moment {
public:
    explicit Moment(const TraceHeader& header) : state_(header) {}

    /// Takes the next event. Throws Impossible, as State does.
    void take(const EventView& event) {
        state_.apply(event);
        event.visit([this](const auto& e) { note(e); });
        event_ = event.copy();
    }

    const State& state() const { return state_; }
    const TraceHeader& header() const { return state_.header(); }
    const Scene& scene() const { return header().scene; }
    /// The event of this step; none before the first.
    const std::optional<Event>& event() const { return event_; }
    /// The windows taken from AW so far, the current one last.
    const std::vector<Window>& visited() const { return visited_; }
    /// For each polygon, by its index in the scene, the corners of the current window where it was nearer than all
    /// before it.
    const std::map<int, std::vector<Corner>>& nearer_at() const { return nearer_at_; }
    /// The points where the polygons of the current list enter and leave its clip polygon, as far as RegionClip has
    /// found them.
    const std::vector<ValuePoint>& entering() const { return entering_; }
    const std::vector<ValuePoint>& leaving() const { return leaving_; }
    /// The counts of the edges so far in the current or last containment test: ray crossings, or octants.
    const std::vector<event::Ray>& rays() const { return rays_; }
    const std::vector<event::Octants>& octants() const { return octants_; }
    /// Whether any pixels have been painted.
    bool is_painted() const { return is_painted_; }

private:
    void note(const event::Pop& e) {
        visited_.push_back(e.window);
        nearer_at_.clear();
        forget_outline();
    }
    void note(const event::Nearer& e) { nearer_at_[e.polygon.index] = e.corners; }
    void note(const event::PopList&) {
        entering_.clear();
        leaving_.clear();
    }
    void note(const event::Entering& e) { entering_.push_back(e.point); }
    void note(const event::Leaving& e) { leaving_.push_back(e.point); }
    void note(const event::Meets&) { forget_outline(); }
    void note(const event::RelationFound&) { forget_outline(); }
    void note(const event::Ray& e) { rays_.push_back(e); }
    void note(const event::Octants& e) { octants_.push_back(e); }
    void note(const event::Paint&) { is_painted_ = true; }
    void note(const auto&) {}
    void forget_outline() {
        rays_.clear();
        octants_.clear();
    }

    State state_;
    std::optional<Event> event_;
    std::vector<Window> visited_;
    std::map<int, std::vector<Corner>> nearer_at_;
    std::vector<ValuePoint> entering_, leaving_;
    std::vector<event::Ray> rays_;
    std::vector<event::Octants> octants_;
    bool is_painted_ = false;
};

/// The index of the polygon that the step is about, or of the current one; none if there is no such polygon.
inline std::optional<int> current_polygon(const Moment& moment) {
    std::optional<int> place;
    if (const auto polygon = moment.state().z_buffer().polygon()) place = polygon->index;
    if (!moment.event()) return place;
    moment.event()->visit([&](const auto& e) {
        if constexpr (requires { e.polygon.index; }) place = e.polygon.index;
    });
    return place;
}

}  // namespace vidno::figures
