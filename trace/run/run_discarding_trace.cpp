/// For builds with sanitizers, which would otherwise compile the same procedures once more for each kernel.
#include "run/untraced.h"

namespace vidno {

Picture untraced_run(const RunRequest& request) { return told_to_nobody(request); }
DrawnLines untraced_run(const FloatingHorizonRequest& request) { return told_to_nobody(request); }

}  // namespace vidno
