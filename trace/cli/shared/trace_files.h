/// Traces as files of the command line, gone through step by step; what cannot be is refused in one line.
#pragma once

#include <string>

#include "format/trace_reader.h"
#include "refused.h"
#include "state/call_stack.h"

namespace vidno::cli {

/// Whether a file is a trace, by its name.
inline bool is_trace(const std::string& file) { return file.ends_with(".jsonl") || file.ends_with(".jsonl.gz"); }

/// After the last event: whether the trace is of a whole run. If not, it is said on standard error.
bool is_whole(const TraceFile& trace);

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
