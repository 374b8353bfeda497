/// What run_family_<kernels>.cpp instantiate: the Warnock family, apart from the course's methods, so that these do not wait for
/// it to be compiled.
#pragma once

#include "run_kernel.h"
#include "vidno/family/family.h"

namespace vidno {

template <Kernel K>
Picture run_family(const RunRequest& request, const K& kernel) {
    return family::with_set_of(request.method, [&]<class Set>(Set) { return run_set<Set>(request, kernel); });
}

}  // namespace vidno
