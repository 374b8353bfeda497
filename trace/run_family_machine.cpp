#include "run_family.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture run_family_float(const RunRequest& request) { return run_family(request, Float{}); }
Picture run_family_double(const RunRequest& request) { return run_family(request, Double{}); }
Picture run_family_bits(const RunRequest& request) { return run_family(request, Bits(request.kernel.parameter)); }

}  // namespace vidno
