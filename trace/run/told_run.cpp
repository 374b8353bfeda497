#include "run/told.h"

namespace vidno {

Picture told_run(const RunRequest& request, const Followers& followers) {
    assert(request.sink);
    if (request.method == Method::weiler_atherton) return told_weiler_atherton(request, followers);
    switch (request.kernel.kind()) {
        case KernelKind::filtered: return told_filtered(request, followers.count);
        case KernelKind::grid: return told_grid(request);
        case KernelKind::binary64:
            if (!followers.judge) return told_double(request);
            [[fallthrough]];
        default: return told_run_time(request, followers);
    }
}

}  // namespace vidno
