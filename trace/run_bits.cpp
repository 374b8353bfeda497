#include "run_kernel.h"
#include "vidno/kernels/bits.h"

namespace vidno {

Picture run_bits(const RunRequest& request) { return run_kernel(request, Bits(request.kernel.parameter)); }

}  // namespace vidno
