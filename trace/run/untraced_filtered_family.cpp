#include "run/untraced_filtered.h"

namespace vidno {

template Picture Untraced<KernelKind::filtered>::family(const RunRequest&);
template Picture Untraced<KernelKind::filtered>::weiler_atherton(const RunRequest&);

}  // namespace vidno
