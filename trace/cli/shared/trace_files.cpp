#include "cli/shared/trace_files.h"

#include <iostream>

#include "counted.h"

namespace vidno::cli {

bool is_whole(const TraceFile& trace) {
    const std::string& place = trace.place();
    if (!trace.end()) {
        std::cerr << place << ": cut short: " << counted(trace.events(), "event", "events")
                  << " read, the last line is missing\n";
        return false;
    }
    if (trace.end()->partial) {
        std::cerr << place << ": partial: the run was stopped after " << counted(trace.events(), "event", "events")
                  << '\n';
        return false;
    }
    return true;
}

}  // namespace vidno::cli
