#include "run/floating_horizon_run.h"

#include <stdexcept>

#include "run/floating_horizon_lines.h"
#include "vidno/kernels/bits.h"
#include "vidno/kernels/filtered_heights.h"
#include "vidno/printed_floating_horizon.h"

namespace vidno {

namespace {

/// The visitor of a run without a trace.
struct FloatingHorizonPacer : NoTrace {
    const std::function<void()>& progress;
    void curve(Line, int) { progress(); }
};

template <Kernel K>
DrawnLines untraced_lines(const FloatingHorizonRequest& request, const K& kernel) {
    const FloatingHorizonPacer pacer{{}, request.progress};
    if constexpr (PrintedKernel<K>) {
        if (request.edition == Edition::printed) return lines_drawn<PrintedFloatingHorizon>(request, kernel, pacer);
    }
    return lines_drawn<CorrectedFloatingHorizon>(request, kernel, pacer);
}

}  // namespace

DrawnLines run(const FloatingHorizonRequest& request) {
    if (!request.kernel.choice->runs_floating_horizon(request.edition)) {
        throw std::invalid_argument(request.kernel.name() + " draws no curves in this edition");
    }
    if (request.sink) return told_floating_horizon(request);
    switch (request.kernel.kind()) {
        case KernelKind::binary32: return untraced_lines(request, Float{});
        case KernelKind::bits: return untraced_lines(request, Bits(request.kernel.parameter));
        case KernelKind::filtered: return untraced_lines(request, Filtered{});
        case KernelKind::exact: return untraced_lines(request, Exact{});
        default: return untraced_lines(request, Double{});
    }
}

ColumnsDrawn columns_drawn(const DrawnLines& lines, const CurveScene& scene) {
    ColumnsDrawn drawn;
    for (const auto& [samples] : scene.curves) {
        drawn.emplace_back(std::size_t(samples.back().x - samples.front().x + 1), false);
    }
    for (const auto& [segment, from, to] : lines) {
        const auto curve = std::size_t(segment.curve);
        const int first = scene.curves[curve].samples.front().x;
        for (int x = from.right; x <= to.left; ++x) drawn[curve][std::size_t(x - first)] = true;
    }
    return drawn;
}

std::uint64_t different_columns(const ColumnsDrawn& one, const ColumnsDrawn& other) {
    std::uint64_t different = 0;
    for (std::size_t curve = 0; curve < one.size(); ++curve) {
        for (std::size_t i = 0; i < one[curve].size(); ++i) different += one[curve][i] == other[curve][i] ? 0 : 1;
    }
    return different;
}

}  // namespace vidno
