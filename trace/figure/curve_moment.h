/// CurveMoment: a step of a run of curves with what a figure shows of it, rebuilt from the events alone.
#pragma once

#include "state/curve_state.h"

namespace vidno::figures {

class CurveMoment {
public:
    explicit CurveMoment(const CurveHeader& header) : state_(header) {}

    /// Takes the next event. Throws Impossible, as CurveState does.
    void take(const EventView& event) {
        state_.apply(event);
        event_ = event.copy();
    }

    const CurveState& state() const { return state_; }
    const CurveHeader& header() const { return state_.header(); }
    const CurveScene& scene() const { return header().scene.curves; }
    /// Of this step; none before the first.
    const std::optional<Event>& event() const { return event_; }

private:
    CurveState state_;
    std::optional<Event> event_;
};

}  // namespace vidno::figures
