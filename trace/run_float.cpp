#include "run_kernel.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture run_float(const RunRequest& request) { return run_kernel(request, Float{}); }

}  // namespace vidno
