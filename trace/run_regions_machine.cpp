#include "run_regions.h"
#include "vidno/kernels/bits.h"

namespace vidno {

Picture run_regions_float(const RunRequest& request) { return run_regions(request, Float{}); }
Picture run_regions_double(const RunRequest& request) { return run_regions(request, Double{}); }
Picture run_regions_bits(const RunRequest& request) { return run_regions(request, Bits(request.kernel.parameter)); }

}  // namespace vidno
