/// The floating horizon: which parts of curves are visible, by the procedures of a set in the arithmetic of a kernel.
///
///     const auto visible = vidno::visible_lines(vidno::admit(curves), vidno::Double{});
///     for (const auto& line : visible.lines) ...
#pragma once

#include "corrected_floating_horizon.h"
#include "kernels/machine.h"

namespace vidno {

/// The visible lines in the order of the curves, each from left to right, and the horizons at the end.
template <FloatingHorizonKernel K>
struct VisibleCurves {
    std::vector<VisibleLine<typename K::Number>> lines;
    Horizons<K> horizons;
};

/// Runs floating_horizon/floating_horizon.h and reports each step to the trace. The numbers are the kernel's.
template <class Set = CorrectedFloatingHorizon, Kernel K, class Trace = NoTrace>
VisibleCurves<OnColumns<K>> visible_lines(const AdmittedCurves& curves, K kernel, Trace trace = {}, Set set = {}) {
    FloatingHorizonRun<Set, OnColumns<K>, Trace> run(curves, OnColumns<K>(std::move(kernel)), std::move(trace),
                                                     std::move(set));
    run.set.floating_horizon(run);
    return {std::move(run.lines), std::move(run.horizons)};
}

}  // namespace vidno
