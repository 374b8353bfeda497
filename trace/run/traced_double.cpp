#include "run/traced_set.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture traced_double(const RunRequest& request) { return traced(request, Double{}); }

}  // namespace vidno
