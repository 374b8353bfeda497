#include "run/untraced_set.h"
#include "vidno/kernels/bits.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::bits> {
    static Bits made(int bits) { return Bits(bits); }
};
template struct Untraced<KernelKind::bits>;

}  // namespace vidno
