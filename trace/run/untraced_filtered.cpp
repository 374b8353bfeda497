#include "run/untraced_set.h"
#include "vidno/kernels/filtered_heights.h"
#include "vidno/kernels/filtered_regions.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::filtered> {
    static Filtered made(int) { return Filtered{}; }
};
template struct Untraced<KernelKind::filtered>;

}  // namespace vidno
