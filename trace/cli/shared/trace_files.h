/// Traces as files of the command line, read step by step; an impossible event is refused in one line.
#pragma once

#include <string>

#include "format/trace_reader.h"
#include "refused.h"
#include "replay/call_stack.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"

namespace vidno::cli {

/// Whether a file is a trace, by its name.
inline bool is_trace(const std::string& file) { return file.ends_with(".jsonl") || file.ends_with(".jsonl.gz"); }

/// The state before a run's first step.
inline State state_of(const TraceReader& reader) { return State(reader.header()); }
inline FloatingHorizonState state_of(const FloatingHorizonTraceReader& reader) {
    return FloatingHorizonState(reader.header());
}

/// Passes the next event of the trace to `take`; false at the end. Throws Refused, with line and step, for an event
/// that cannot follow.
bool take_next(TraceFile& trace, auto&& take) {
    const auto event = trace.next();
    if (!event) return false;
    try {
        take(*event);
    } catch (const Impossible& impossible) {
        throw Refused(trace.place() + ": step " + std::to_string(trace.events()) + ": " + impossible.reason);
    }
    return true;
}

/// The refusal of a step that the trace does not have.
[[noreturn]] inline void refuse_step(const std::string& file, std::uint64_t step, std::uint64_t last) {
    throw Refused(file + ": there is no step " + std::to_string(step) + ", the last is " + std::to_string(last));
}

}  // namespace vidno::cli
