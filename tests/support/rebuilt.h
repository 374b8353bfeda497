/// The state that a trace's reader builds, made from a run's events while the run goes on.
#pragma once

#include "recorder.h"
#include "state.h"

namespace vidno::test {

struct ToState {
    State& state;
    template <class E>
    void operator()(const E& event) {
        state.apply(Event(event));
    }
};

/// The state rebuilt from a run's events, and how often it was held against the run's own lists.
struct Rebuilt {
    explicit Rebuilt(const TraceHeader& header) : state(header), sink{state}, recording{header.detail, sink} {}
    State state;
    ToState sink;
    Recording<ToState> recording;
    int compared = 0, different = 0;
};

}  // namespace vidno::test
