/// Until: the step of a run at which a condition is first met.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "run/run.h"

namespace vidno {

/// The number of events of the request's level until the condition is met, with the one that meets it; none if the run
/// never meets it. Throws Refused for a text that is no condition, and for names that are known only once a run has
/// ended.
std::optional<std::uint64_t> events_until(const std::string& condition, RunRequest request);

}  // namespace vidno
