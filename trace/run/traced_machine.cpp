#include "run/machine_kernel.h"
#include "run/told_set.h"

namespace vidno {

Picture told_machine(const RunRequest& request) { return told(request, MachineKernel(request.kernel)); }

}  // namespace vidno
