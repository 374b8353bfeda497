#include "run/untraced_filtered.h"

namespace vidno {

template Picture Untraced<KernelKind::filtered>::course(const RunRequest&);
template DrawnLines Untraced<KernelKind::filtered>::floating_horizon(const FloatingHorizonRequest&);

}  // namespace vidno
