/// Runs without a trace: one or two translation units a kernel, compiled for its own numbers.
#pragma once

#include "run/floating_horizon_run.h"
#include "run/run.h"

namespace vidno {

/// The request has no sink and is no mistake's.
Picture untraced_run(const RunRequest&);
DrawnLines untraced_run(const FloatingHorizonRequest&);

/// A told run whose events nobody hears.
Picture told_to_nobody(RunRequest);
DrawnLines told_to_nobody(FloatingHorizonRequest);

/// A kernel's methods, of those that it runs: see its KernelChoice. They are defined in `untraced_<kernel>.cpp` and what begins like it.
template <KernelKind kind>
struct Untraced {
    static Picture course(const RunRequest&);
    static Picture family(const RunRequest&);
    static Picture weiler_atherton(const RunRequest&);
    static DrawnLines floating_horizon(const FloatingHorizonRequest&);
};

}  // namespace vidno
