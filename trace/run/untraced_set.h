/// What the units of runs without a trace instantiate.
#pragma once

#include "run/untraced.h"
#include "vidno/printed.h"
#include "vidno/vidno.h"

namespace vidno {

/// The visitor of a run without a trace: whoever waits for it sees that it goes on.
struct Pacer : NoTrace {
    const std::function<void()>& progress;

    void pop(Line, const auto&) { progress(); }
    void polygon(Line, const auto&) { progress(); }
};

template <class Set, Kernel K>
Picture untraced_set(const RunRequest& request, const K& kernel) {
    return render<Set>(request.method, request.scene, kernel, Pacer{{}, request.progress}, request.smallest_window);
}

/// The methods of the course.
template <Kernel K>
Picture untraced(const RunRequest& request, const K& kernel) {
    if constexpr (PrintedKernel<K>) {
        if (request.edition == Edition::printed) return untraced_set<Printed>(request, kernel);
    }
    return untraced_set<Corrected>(request, kernel);
}

}  // namespace vidno
