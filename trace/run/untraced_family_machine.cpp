#include "run/untraced_family.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture untraced_family_float(const RunRequest& request) { return untraced_family(request, Float{}); }
Picture untraced_family_double(const RunRequest& request) { return untraced_family(request, Double{}); }
Picture untraced_family_bits(const RunRequest& request) {
    return untraced_family(request, Bits(request.kernel.parameter));
}

}  // namespace vidno
