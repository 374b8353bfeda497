#include "run/untraced_set.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture untraced_double(const RunRequest& request) { return untraced(request, Double{}); }

}  // namespace vidno
