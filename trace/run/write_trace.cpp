#include "run/write_trace.h"

namespace vidno {

bool write_trace(RunRequest request, TraceWriter& writer) {
    request.sink = &writer;
    return write_run(writer, [&] { return traced_run(request); });
}

bool write_trace(FloatingHorizonRequest request, TraceWriter& writer) {
    request.sink = &writer;
    return write_run(writer, [&] { return traced_floating_horizon(request); });
}

}  // namespace vidno
