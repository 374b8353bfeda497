#include "run_kernel.h"
#include "vidno/kernels/exact.h"

namespace vidno {

Picture run_exact(const RunRequest& request) { return run_kernel(request, Exact{}); }

}  // namespace vidno
