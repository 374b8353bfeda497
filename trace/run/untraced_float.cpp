#include "run/untraced_set.h"
#include "vidno/kernels/machine.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::binary32> {
    static Float made(int) { return Float{}; }
};
template struct Untraced<KernelKind::binary32>;

}  // namespace vidno
