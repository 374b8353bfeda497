#include "run/untraced_set.h"
#include "vidno/kernels/depth_bits.h"

namespace vidno {

Picture untraced_depth(const RunRequest& request) { return untraced(request, DepthBits(request.kernel.parameter)); }

}  // namespace vidno
