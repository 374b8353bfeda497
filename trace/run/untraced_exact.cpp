#include "run/untraced_set.h"
#include "vidno/kernels/exact.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::exact> {
    static Exact made(int) { return Exact{}; }
};
template struct Untraced<KernelKind::exact>;

}  // namespace vidno
