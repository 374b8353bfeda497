#include "run/told.h"

namespace vidno {

namespace {

/// Warnock's algorithm, its variants and the Z-buffer.
Picture told_set(const RunRequest& request, const Followers& followers) {
    switch (request.kernel.kind()) {
        case KernelKind::filtered: return told_filtered(request, followers.count);
        case KernelKind::grid: return told_grid(request);
        case KernelKind::exact: return told_run_time(request, followers);
        default:
            if (followers.judge) return told_run_time(request, followers);
            return request.kernel.kind() == KernelKind::binary64 ? told_double(request) : told_machine(request);
    }
}

}  // namespace

Picture told_run(const RunRequest& request, const Followers& followers) {
    assert(request.sink);
    switch (algorithm_of(request.method)) {
        case Algorithm::warnock:
        case Algorithm::z_buffer: return told_set(request, followers);
        case Algorithm::weiler_atherton: return told_weiler_atherton(request, followers);
    }
    std::abort();
}

}  // namespace vidno
