#include "run/untraced_set.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture untraced_float(const RunRequest& request) { return untraced(request, Float{}); }

}  // namespace vidno
