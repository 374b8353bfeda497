#include "run/run_time_kernel.h"
#include "run/traced_set.h"

namespace vidno {

Picture traced_run_time(const RunRequest& request, const Followers& followers) {
    return traced(request, RunTimeKernel(request.kernel, followers));
}

}  // namespace vidno
