#include "run/untraced_set.h"
#include "vidno/kernels/machine.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::binary64> {
    static Double made(int) { return Double{}; }
};
template struct Untraced<KernelKind::binary64>;

}  // namespace vidno
