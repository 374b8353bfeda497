/// Runs without a trace: one or two translation units a kernel, compiled for its own numbers.
#pragma once

#include "run/floating_horizon_run.h"
#include "run/run.h"

namespace vidno {

/// Usual mistakes and single defects are compiled for told runs alone: without a trace they are told to nobody.
constexpr bool is_compiled_untraced(Edition edition) {
    return edition == Edition::corrected || edition == Edition::printed;
}

/// The request has no sink, and its edition is compiled untraced.
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
