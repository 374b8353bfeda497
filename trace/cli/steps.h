/// Going through a trace step by step; what cannot be is refused in one line.
#pragma once

#include "format/trace_reader.h"
#include "refused.h"
#include "state/call_stack.h"

namespace vidno::cli {

/// Gives `take` the next event of the trace; false at the end. Throws Refused, with line and step, if it cannot follow.
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

/// For a step that the trace has not.
[[noreturn]] inline void refuse_step(const std::string& file, std::uint64_t step, std::uint64_t last) {
    throw Refused(file + ": there is no step " + std::to_string(step) + ", the last is " + std::to_string(last));
}

}  // namespace vidno::cli
