/// SeenFailure: the step of its run at which a failure is seen, and what is seen there.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "format/event.h"
#include "scene/failure.h"

namespace vidno {

struct SeenFailure {
    /// The step in a trace of level `signs`: that of the first wrong decision, or one that is visibly wrong. None if no
    /// single step shows the failure.
    std::optional<std::uint64_t> step;
    /// The decision and the exact one, or the painted colour and the right one.
    Failure::Words there;
    /// The event of that step, if it reports a wrong decision.
    std::optional<Event> event;
};

/// Runs a failure that has a scene, both as it fails and as it holds, until the failure is seen.
SeenFailure seen(const Failure& failure);

/// Traces a failure that has a scene as it fails, at level `signs`. A trace that is too long is cut short.
void write_failing_run(const Failure& failure, std::function<void(std::string_view)> write);

}  // namespace vidno
