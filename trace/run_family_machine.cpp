#include "run_family.h"
#include "vidno/kernels/machine.h"

namespace vidno {

Picture run_family_float(const RunRequest& request) { return run_family(request, Float{}); }
Picture run_family_double(const RunRequest& request) { return run_family(request, Double{}); }

}  // namespace vidno
