/// State: everything that a method holds at a step, rebuilt from the events alone. FloatingHorizonState is the
/// equivalent for curves.
#pragma once

#include "choice/algorithm.h"
#include "replay/warnock_state.h"
#include "replay/weiler_atherton_state.h"
#include "replay/z_buffer_state.h"

namespace vidno {

class State {
public:
    /// Everything except the screen. Only the state of the method's own algorithm changes.
    struct Values {
        CallStack calls;
        WarnockState warnock;
        ZBufferState z_buffer;
        WeilerAthertonState weiler_atherton;
    };

    /// The header must outlive the state.
    explicit State(const TraceHeader& header);

    /// Takes the next event. If it throws Impossible, discard the state, which may be inconsistent.
    void apply(const EventView& event);

    std::uint64_t step() const { return step_; }
    const TraceHeader& header() const { return *header_; }
    const Screen& screen() const { return screen_; }
    Picture picture() const { return screen_.picture(); }
    const Values& values() const { return values_; }

    const std::vector<CallStack::Frame>& calls() const { return values_.calls.frames(); }
    const WarnockState& warnock() const { return values_.warnock; }
    const ZBufferState& z_buffer() const { return values_.z_buffer; }
    const WeilerAthertonState& weiler_atherton() const { return values_.weiler_atherton; }

private:
    template <class Own, class E>
    void take(Own& state, const E& event);

    const TraceHeader* header_;
    std::uint64_t step_ = 0;
    Screen screen_;
    Values values_;
};

/// The state as JSON on one line.
std::string state_json(const State& state);

}  // namespace vidno
