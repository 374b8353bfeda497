#include "run/untraced_set.h"
#include "vidno/kernels/filtered.h"

namespace vidno {

Picture untraced_filtered(const RunRequest& request) { return untraced(request, Filtered{}); }

}  // namespace vidno
