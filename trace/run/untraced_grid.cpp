#include "run/untraced_set.h"
#include "vidno/kernels/grid.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::grid> {
    static Grid made(int bits) { return Grid(bits); }
};
template Picture Untraced<KernelKind::grid>::course(const RunRequest&);
template Picture Untraced<KernelKind::grid>::family(const RunRequest&);

}  // namespace vidno
