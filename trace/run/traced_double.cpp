#include "run/told_set.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture told_double(const RunRequest& request) { return told(request, Double{}); }

}  // namespace vidno
