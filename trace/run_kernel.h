/// What each run_<kernel>.cpp instantiates.
#pragma once

#include "recorder.h"
#include "run.h"
#include "vidno/printed.h"

namespace vidno {

/// The visitor of a run without a trace: whoever waits for it sees that it goes on.
struct Pacer : NoTrace {
    const std::function<void()>& progress;

    void pop(Line, const auto&) { progress(); }
    void polygon(Line, const auto&) { progress(); }
};

template <class Set, Kernel K>
Picture traced_set(const RunRequest& request, const K& kernel) {
    Recording<TraceWriter> recording{request.detail, *request.writer};
    const Recorder<K, TraceWriter> recorder(recording);
    return render<Set>(request.method, request.scene, kernel, recorder, request.smallest_window);
}

template <class Set, Kernel K>
Picture run_set(const RunRequest& request, const K& kernel) {
    if (request.writer) return traced_set<Set>(request, kernel);
    return render<Set>(request.method, request.scene, kernel, Pacer{{}, request.progress}, request.smallest_window);
}

template <Kernel K>
Picture run_kernel(const RunRequest& request, const K& kernel) {
    if constexpr (PrintedKernel<K>) {
        if (request.edition == Edition::printed) return run_set<Printed>(request, kernel);
    }
    return run_set<Corrected>(request, kernel);
}

}  // namespace vidno
