#include "replay/state.h"

#include "choice/method.h"

namespace vidno {

State::State(const TraceHeader& header)
    : header_(&header),
      screen_(header),
      values_{CallStack(choice_of(header.method).procedure, header.detail), WarnockState(header), ZBufferState(header),
              WeilerAthertonState(header)} {}

/// An event that has no `take` changes nothing.
template <class Own, class E>
void State::take(Own& state, const E& event) {
    if constexpr (!Own::Events::template has<E>()) {
        throw Impossible{"an event of another method"};
    } else if constexpr (requires { state.take(event, screen_); }) {
        state.take(event, screen_);
    }
}

void State::apply(const EventView& event) {
    screen_.begin(step_ + 1);
    event.visit([this](const auto& e) {
        values_.calls.take(e);
        switch (algorithm_of(header_->method)) {
            case Algorithm::warnock: return take(values_.warnock, e);
            case Algorithm::z_buffer: return take(values_.z_buffer, e);
            case Algorithm::weiler_atherton: return take(values_.weiler_atherton, e);
        }
    });
    ++step_;
}

}  // namespace vidno
