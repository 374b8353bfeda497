/// FloatingHorizonMoment: a step of a run of curves with everything that a figure shows of it, rebuilt from the events
/// alone.
#pragma once

#include "replay/floating_horizon_state.h"

namespace vidno::figures {

class FloatingHorizonMoment {
public:
    explicit FloatingHorizonMoment(const FloatingHorizonHeader& header) : state_(header) {}

    /// Takes the next event. Throws Impossible, as FloatingHorizonState does.
    void take(const EventView& event) {
        state_.apply(event);
        event_ = event.copy();
    }

    const FloatingHorizonState& state() const { return state_; }
    const FloatingHorizonHeader& header() const { return state_.header(); }
    const CurveScene& scene() const { return header().scene.curves; }
    /// The event of this step; none before the first.
    const std::optional<Event>& event() const { return event_; }

private:
    FloatingHorizonState state_;
    std::optional<Event> event_;
};

}  // namespace vidno::figures
