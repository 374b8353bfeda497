/// The templates that the units for reported runs instantiate.
#pragma once

#include "run/recorder.h"
#include "run/run_time_set.h"
#include "run/traced.h"

namespace vidno {

template <Kernel K>
Picture traced(const RunRequest& request, const K& kernel) {
    Recording recording{request.detail, *request.sink};
    const Recorder<K> recorder(recording);
    const auto run_set = [&](const auto& set) {
        return render(request.method, request.scene, kernel, recorder, request.smallest_window, set);
    };
    if constexpr (PrintedKernel<K>) {
        return run_set(AnyEdition(request.method, request.edition));
    } else {
        return run_set(AnyMethod(request.method));
    }
}

}  // namespace vidno
