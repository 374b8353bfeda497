/// CallStack: which procedures are running at a step, rebuilt from the events.
#pragma once

#include <type_traits>
#include <vector>

#include "format/event.h"

namespace vidno {

/// Why an event cannot follow.
struct Impossible {
    std::string reason;
};

class CallStack {
public:
    struct Frame {
        Procedure of;
        std::optional<Line> at;
        bool operator==(const Frame&) const = default;
        static void fields(auto& frame, auto&& field) {
            field("of", frame.of);
            field("at", frame.at);
        }
    };

    /// The bottom frame is that of the method.
    CallStack(Procedure method, Detail detail) : detail_(detail), frames_{{method, std::nullopt}} {}

    const std::vector<Frame>& frames() const { return frames_; }  // outermost first

    template <class E>
    void take(const E& event) {
        if constexpr (requires { E::result_of; }) end(E::result_of);
        frames_.back().at = event.at;
        if constexpr (std::is_same_v<E, event::Call>) begin(event.of);
    }

private:
    void begin(Procedure procedure) {
        if (frames_.size() > procedure_names.size()) throw Impossible{"the call stack is too deep"};
        frames_.push_back({procedure, std::nullopt});
    }

    /// A result closes the frame that its `call` opened. Below the level of the call there is no such frame.
    void end(Procedure procedure) {
        if (detail_ < event::calls_from(procedure)) return;
        if (frames_.back().of != procedure) throw Impossible{"a result of a procedure that is not running"};
        frames_.pop_back();
    }

    Detail detail_;
    std::vector<Frame> frames_;
};

}  // namespace vidno
