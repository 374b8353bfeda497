/// The Warnock family without a trace, apart from the methods of the course: these do not wait for it to be compiled.
#pragma once

#include "run/untraced_set.h"
#include "vidno/family/family.h"

namespace vidno {

template <Kernel K>
Picture untraced_family(const RunRequest& request, const K& kernel) {
    return family::with_set_of(request.method, [&]<class Set>(Set) { return untraced_set<Set>(request, kernel); });
}

}  // namespace vidno
