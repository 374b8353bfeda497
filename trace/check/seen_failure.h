/// SeenFailure: at which step of its run a failure is seen, and what is there.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "format/event.h"
#include "scene/failure.h"

namespace vidno {

struct SeenFailure {
    /// Of a trace of level `signs`: the first wrong decision, or the step that is seen to be wrong. None if no one step shows it.
    std::optional<std::uint64_t> step;
    /// What was decided and what is exact, or what is painted and what should be.
    Failure::Words there;
    /// The event of that step, if it tells a wrong decision.
    std::optional<Event> event;
};

/// Runs a failure that has a scene, as it fails and as it holds, as far as it takes to see it.
SeenFailure seen(const Failure& failure);

/// Traces a failure that has a scene as it fails, on level `signs`; one that goes on and on is cut.
void write_failing_run(const Failure& failure, std::function<void(std::string_view)> write);

}  // namespace vidno
