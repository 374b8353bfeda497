#include "run_kernel.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture run_double(const RunRequest& request) { return run_kernel(request, Double{}); }

}  // namespace vidno
