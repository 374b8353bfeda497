#include "run/untraced_set.h"
#include "vidno/kernels/bits.h"

namespace vidno {

Picture untraced_bits(const RunRequest& request) { return untraced(request, Bits(request.kernel.parameter)); }

}  // namespace vidno
