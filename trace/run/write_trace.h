/// Traces runs to the end of a file.
#pragma once

#include "run/floating_horizon_run.h"
#include "run/run.h"

namespace vidno {

/// Traces a run to the end of its file. False if the writer's limit ended the run, so that the trace is partial.
bool write_trace(RunRequest request, TraceWriter& writer);
bool write_trace(FloatingHorizonRequest request, TraceWriter& writer);

// The last line of a trace has the result of its run.
inline void finish(TraceWriter& writer, const Picture& picture) { writer.finish(picture); }
inline void finish(TraceWriter& writer, const DrawnLines& lines) { writer.finish("lines", lines_hash(lines)); }

/// Writes the trace of `run()`, which reports to the writer.
bool write_run(TraceWriter& writer, auto&& run) {
    try {
        finish(writer, run());
        return true;
    } catch (const EventLimitReached&) {
        writer.finish_partial();
        return false;
    }
}

}  // namespace vidno
