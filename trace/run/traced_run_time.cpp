#include "run/run_time_kernel.h"
#include "run/told_set.h"

namespace vidno {

Picture told_run_time(const RunRequest& request, const Followers& followers) {
    return told(request, RunTimeKernel(request.kernel, followers));
}

}  // namespace vidno
