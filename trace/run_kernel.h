/// What each run_<kernel>.cpp instantiates.
#pragma once

#include "recorder.h"
#include "run.h"
#include "vidno/printed.h"

namespace vidno {

template <class Set, Kernel K>
Picture run_set(const RunRequest& request, K kernel) {
    if (!request.writer) return render<Set>(request.method, request.scene, kernel);
    Recording<TraceWriter> recording{request.detail, *request.writer};
    return render<Set>(request.method, request.scene, kernel, Recorder<K, TraceWriter>(recording));
}

template <Kernel K>
Picture run_kernel(const RunRequest& request, K kernel) {
    return request.printed ? run_set<Printed>(request, kernel) : run_set<Corrected>(request, kernel);
}

}  // namespace vidno
