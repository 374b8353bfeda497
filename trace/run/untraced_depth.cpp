#include "run/untraced_set.h"
#include "vidno/kernels/depth_bits.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::depth> {
    static DepthBits made(int bits) { return DepthBits(bits); }
};
template Picture Untraced<KernelKind::depth>::course(const RunRequest&);

}  // namespace vidno
