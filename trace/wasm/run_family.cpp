/// The Warnock family in the page's library, where a run is always told to a trace.

#include "run_family.h"

#include "vidno/kernels/filtered.h"
#include "vidno/kernels/machine.h"

namespace vidno {

namespace {

template <Kernel K>
Picture traced(const RunRequest& request, const K& kernel) {
    return family::with_set_of(request.method, [&]<class Set>(Set) { return traced_set<Set>(request, kernel); });
}

}  // namespace

Picture run_family_float(const RunRequest& request) { return traced(request, Float{}); }
Picture run_family_double(const RunRequest& request) { return traced(request, Double{}); }
Picture run_family_bits(const RunRequest& request) { return traced(request, Bits(request.kernel.parameter)); }
Picture run_family_filtered(const RunRequest& request) { return traced(request, Filtered{}); }
Picture run_family_grid(const RunRequest& request) { return traced(request, Grid(request.kernel.parameter)); }
Picture run_family_exact(const RunRequest& request) { return traced(request, Exact{}); }

}  // namespace vidno
