/// The state that a trace's reader builds, from a run's events while it runs.
#pragma once

#include "run/recorder.h"

namespace vidno::test {

/// The state rebuilt from a run's events, and how often it was compared with the run's own lists.
template <class State>
struct Rebuilt final : EventSink {
    explicit Rebuilt(const auto& header) : state(header), recording{header.detail, *this} {}

    void hear(const EventView& event) override { state.apply(event); }

    void expect(bool same) {
        ++compared;
        different += same ? 0 : 1;
    }

    State state;
    Recording recording;
    int compared = 0, different = 0;
};

/// Records into a rebuilt state. Derive from it to compare the run's own lists with that state.
template <class K, class State>
class RebuildingRecorder : public Recorder<K> {
public:
    explicit RebuildingRecorder(Rebuilt<State>& rebuilt) : Recorder<K>(rebuilt.recording), rebuilt_(&rebuilt) {}

protected:
    Rebuilt<State>* rebuilt_;
};

}  // namespace vidno::test
