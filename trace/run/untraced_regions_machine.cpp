#include "run/untraced_regions.h"
#include "vidno/kernels/bits.h"

namespace vidno {

Picture untraced_regions_float(const RunRequest& request) { return untraced_regions(request, Float{}); }
Picture untraced_regions_double(const RunRequest& request) { return untraced_regions(request, Double{}); }
Picture untraced_regions_bits(const RunRequest& request) {
    return untraced_regions(request, Bits(request.kernel.parameter));
}

}  // namespace vidno
