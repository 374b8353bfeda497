#include "run_family.h"
#include "vidno/kernels/filtered.h"

namespace vidno {

Picture run_family_filtered(const RunRequest& request) { return run_family(request, Filtered{}); }
Picture run_family_grid(const RunRequest& request) { return run_family(request, Grid(request.kernel.parameter)); }
Picture run_family_exact(const RunRequest& request) { return run_family(request, Exact{}); }

}  // namespace vidno
