#include "run/machine_kernel.h"
#include "run/traced_set.h"

namespace vidno {

Picture traced_machine(const RunRequest& request) { return traced(request, MachineKernel(request.kernel)); }

}  // namespace vidno
