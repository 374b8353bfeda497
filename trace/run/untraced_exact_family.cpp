#include "run/untraced_exact.h"

namespace vidno {

template Picture Untraced<KernelKind::exact>::family(const RunRequest&);
template Picture Untraced<KernelKind::exact>::weiler_atherton(const RunRequest&);

}  // namespace vidno
