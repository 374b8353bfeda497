/// Runs without a trace: one or two translation units per kernel, compiled for its own numbers.
#pragma once

#include "run/floating_horizon_run.h"
#include "run/run.h"

namespace vidno {

/// Usual mistakes and single defects are compiled only for reported runs. Without a trace they report to a sink that
/// ignores the events.
constexpr bool is_compiled_untraced(Edition edition) {
    return edition == Edition::corrected || edition == Edition::printed;
}

/// Requires a request without a sink, whose edition is compiled untraced.
Picture untraced_run(const RunRequest&);
DrawnLines untraced_run(const FloatingHorizonRequest&);

/// A reported run whose events are ignored.
Picture run_and_discard_trace(RunRequest);
DrawnLines run_and_discard_trace(FloatingHorizonRequest);

/// The methods that a kernel runs (see its KernelChoice). They are defined in `untraced_<kernel>*.cpp`.
template <KernelKind kind>
struct Untraced {
    static Picture course(const RunRequest&);
    static Picture family(const RunRequest&);
    static Picture weiler_atherton(const RunRequest&);
    static DrawnLines floating_horizon(const FloatingHorizonRequest&);
};

}  // namespace vidno
