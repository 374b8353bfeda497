#include "run/untraced_set.h"
#include "vidno/kernels/exact.h"

namespace vidno {

Picture untraced_exact(const RunRequest& request) { return untraced(request, Exact{}); }

}  // namespace vidno
