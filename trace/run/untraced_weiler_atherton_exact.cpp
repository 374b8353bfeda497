#include "run/untraced_weiler_atherton.h"
#include "vidno/kernels/filtered_regions.h"

namespace vidno {

Picture untraced_weiler_atherton_filtered(const RunRequest& request) {
    return untraced_weiler_atherton(request, Filtered{});
}
Picture untraced_weiler_atherton_exact(const RunRequest& request) { return untraced_weiler_atherton(request, Exact{}); }

}  // namespace vidno
