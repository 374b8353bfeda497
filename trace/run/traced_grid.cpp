#include "run/told_set.h"

namespace vidno {

Picture told_grid(const RunRequest& request) { return told(request, Grid(request.kernel.parameter)); }

}  // namespace vidno
