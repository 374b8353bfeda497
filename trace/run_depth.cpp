#include "run_kernel.h"
#include "vidno/kernels/depth_bits.h"

namespace vidno {

Picture run_depth(const RunRequest& request) { return run_kernel(request, DepthBits(request.kernel.parameter)); }

}  // namespace vidno
