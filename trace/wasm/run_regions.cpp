/// Weiler and Atherton's algorithm in the page's library, where a run is always told to a trace.

#include "run_regions.h"

#include "vidno/kernels/bits.h"
#include "vidno/kernels/filtered_regions.h"

namespace vidno {

Picture run_regions_float(const RunRequest& request) { return traced_regions(request, Float{}); }
Picture run_regions_double(const RunRequest& request) { return traced_regions(request, Double{}); }
Picture run_regions_bits(const RunRequest& request) { return traced_regions(request, Bits(request.kernel.parameter)); }
Picture run_regions_filtered(const RunRequest& request) { return traced_regions(request, Filtered{}); }
Picture run_regions_exact(const RunRequest& request) { return traced_regions(request, Exact{}); }

}  // namespace vidno
