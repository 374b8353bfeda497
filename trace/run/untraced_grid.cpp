#include "run/untraced_set.h"
#include "vidno/kernels/grid.h"

namespace vidno {

Picture untraced_grid(const RunRequest& request) { return untraced(request, Grid(request.kernel.parameter)); }

}  // namespace vidno
