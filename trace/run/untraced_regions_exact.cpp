#include "run/untraced_regions.h"
#include "vidno/kernels/filtered_regions.h"

namespace vidno {

Picture untraced_regions_filtered(const RunRequest& request) { return untraced_regions(request, Filtered{}); }
Picture untraced_regions_exact(const RunRequest& request) { return untraced_regions(request, Exact{}); }

}  // namespace vidno
