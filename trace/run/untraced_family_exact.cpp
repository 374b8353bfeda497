#include "run/untraced_family.h"
#include "vidno/kernels/filtered.h"

namespace vidno {

Picture untraced_family_filtered(const RunRequest& request) { return untraced_family(request, Filtered{}); }
Picture untraced_family_grid(const RunRequest& request) {
    return untraced_family(request, Grid(request.kernel.parameter));
}
Picture untraced_family_exact(const RunRequest& request) { return untraced_family(request, Exact{}); }

}  // namespace vidno
