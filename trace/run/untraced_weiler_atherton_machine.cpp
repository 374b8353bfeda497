#include "run/untraced_weiler_atherton.h"
#include "vidno/kernels/bits.h"

namespace vidno {

Picture untraced_weiler_atherton_float(const RunRequest& request) { return untraced_weiler_atherton(request, Float{}); }
Picture untraced_weiler_atherton_double(const RunRequest& request) {
    return untraced_weiler_atherton(request, Double{});
}
Picture untraced_weiler_atherton_bits(const RunRequest& request) {
    return untraced_weiler_atherton(request, Bits(request.kernel.parameter));
}

}  // namespace vidno
