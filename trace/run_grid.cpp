#include "run_kernel.h"
#include "vidno/kernels/grid.h"

namespace vidno {

Picture run_grid(const RunRequest& request) { return run_kernel(request, Grid(request.kernel.parameter)); }

}  // namespace vidno
