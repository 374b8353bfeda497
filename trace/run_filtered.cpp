#include "run_kernel.h"
#include "vidno/kernels/filtered.h"

namespace vidno {

Picture run_filtered(const RunRequest& request) { return run_kernel(request, Filtered{}); }

}  // namespace vidno
