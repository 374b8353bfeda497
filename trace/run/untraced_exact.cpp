#include "run/untraced_exact.h"

namespace vidno {

template Picture Untraced<KernelKind::exact>::course(const RunRequest&);
template DrawnLines Untraced<KernelKind::exact>::floating_horizon(const FloatingHorizonRequest&);

}  // namespace vidno
