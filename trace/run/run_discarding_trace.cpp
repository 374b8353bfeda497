/// For builds with sanitizers, which would otherwise compile the same procedures once more for each kernel.
#include "run/untraced.h"

namespace vidno {

Picture untraced_run(const RunRequest& request) { return run_and_discard_trace(request); }
DrawnLines untraced_run(const FloatingHorizonRequest& request) { return run_and_discard_trace(request); }

}  // namespace vidno
