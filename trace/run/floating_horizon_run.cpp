#include "run/floating_horizon_run.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "run/untraced.h"

namespace vidno {

DrawnLines run_and_discard_trace(FloatingHorizonRequest request) {
    FunctionSink sink([progress = request.progress](const EventView& event) {
        if (event.get_if<event::Curve>()) progress();
    });
    request.detail = Detail::windows;
    request.sink = &sink;
    return traced_floating_horizon(request);
}

DrawnLines run(const FloatingHorizonRequest& request) {
    if (!request.kernel.choice->runs_floating_horizon(request.edition)) {
        throw std::invalid_argument(request.kernel.name() + " draws no curves in this edition");
    }
    if (request.sink) return traced_floating_horizon(request);
    return is_compiled_untraced(request.edition) ? untraced_run(request) : run_and_discard_trace(request);
}

std::vector<Loss> losses_of(FloatingHorizonRequest request, const DrawnLines& lines) {
    const auto is_finite = [](const LineEnd<Value>& end) {
        return std::isfinite(number_of(end.point.x)) && std::isfinite(number_of(end.point.y));
    };
    const auto is_whole = [&](const auto& line) { return is_finite(line.from) && is_finite(line.to); };
    if (std::all_of(lines.begin(), lines.end(), is_whole)) return {};
    RunLosses losses(request.kernel.name());
    FunctionSink sink([&](const EventView& event) { losses.hear(event); });
    request.detail = Detail::signs;
    request.sink = &sink;
    traced_floating_horizon(request);
    return losses.all({});
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
