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
Picture run_set(const RunRequest& request, K kernel) {
    const auto told_to = [&](auto trace) {
        return render<Set>(request.method, request.scene, kernel, trace, request.smallest_window);
    };
    if (!request.writer) return told_to(Pacer{{}, request.progress});
    Recording<TraceWriter> recording{request.detail, *request.writer};
    return told_to(Recorder<K, TraceWriter>(recording));
}

template <Kernel K>
Picture run_kernel(const RunRequest& request, K kernel) {
    if constexpr (PrintedKernel<K>) {
        if (request.edition == Edition::printed) return run_set<Printed>(request, kernel);
    }
    return run_set<Corrected>(request, kernel);
}

}  // namespace vidno
