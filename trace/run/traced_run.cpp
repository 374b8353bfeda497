#include "run/traced.h"

namespace vidno {

namespace {

/// Warnock's algorithm, its variants and the Z-buffer.
Picture traced_set(const RunRequest& request, const Followers& followers) {
    switch (request.kernel.kind()) {
        case KernelKind::filtered: return traced_filtered(request, followers.count);
        case KernelKind::grid: return traced_grid(request);
        case KernelKind::exact: return traced_run_time(request, followers);
        default:
            if (followers.judge) return traced_run_time(request, followers);
            return request.kernel.kind() == KernelKind::binary64 ? traced_double(request) : traced_machine(request);
    }
}

}  // namespace

Picture traced_run(const RunRequest& request, const Followers& followers) {
    assert(request.sink);
    switch (algorithm_of(request.method)) {
        case Algorithm::warnock:
        case Algorithm::z_buffer: return traced_set(request, followers);
        case Algorithm::weiler_atherton: return traced_weiler_atherton(request, followers);
    }
    std::abort();
}

}  // namespace vidno
