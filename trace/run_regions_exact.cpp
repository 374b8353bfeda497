#include "run_regions.h"
#include "vidno/kernels/filtered_regions.h"

namespace vidno {

Picture run_regions_filtered(const RunRequest& request) { return run_regions(request, Filtered{}); }
Picture run_regions_exact(const RunRequest& request) { return run_regions(request, Exact{}); }

}  // namespace vidno
