/// Until: traces of runs that end at the step at which a condition is met.
#pragma once

#include <string>

#include "run/write_trace.h"

namespace vidno {

/// Traces a run until the condition is met, with the step that meets it. A step of a finer level than the request's
/// counts too, but is not written. False if the run was cut short there. Throws Refused for a text that is no condition
/// of such a run, and for names that are known only once a run has ended.
bool write_trace_until(const std::string& condition, const RunRequest& request, TraceWriter& writer);
bool write_trace_until(const std::string& condition, const FloatingHorizonRequest& request, TraceWriter& writer);

}  // namespace vidno
