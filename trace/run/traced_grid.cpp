#include "run/traced_set.h"

namespace vidno {

Picture traced_grid(const RunRequest& request) { return traced(request, Grid(request.kernel.parameter)); }

}  // namespace vidno
