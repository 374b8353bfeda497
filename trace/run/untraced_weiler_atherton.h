/// Weiler and Atherton's algorithm without a trace.
#pragma once

#include "run/untraced.h"
#include "run/weiler_atherton_run.h"

namespace vidno {

/// The visitor of a run without a trace: whoever waits for it sees that it goes on.
struct WeilerAthertonPacer : NoTrace {
    const std::function<void()>& progress;

    void pop_list(Line, const auto& /*pieces*/) { progress(); }
};

template <Kernel K>
Picture untraced_weiler_atherton(const RunRequest& request, const K& kernel) {
    return weiler_atherton_run(request, kernel, WeilerAthertonPacer{{}, request.progress});
}

}  // namespace vidno
