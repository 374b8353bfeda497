#include "worked_curves.h"

#include "run/floating_horizon_run.h"

namespace vidno::figures {

WorkedCurves::WorkedCurves(const Surface& surface)
    : header_{Edition::corrected, "exact", Detail::signs, surface}, end_(header_) {
    FunctionSink sink([this](const EventView& event) {
        end_.take(event);
        event.visit([this](const auto& e) { hear(e); });
    });
    FloatingHorizonRequest request{kernel_of(KernelKind::exact), Edition::corrected, header_.scene.curves,
                                   Detail::signs};
    request.sink = &sink;
    run(request);
}

void WorkedCurves::hear(const event::Curve&) {
    curves_.emplace_back().step = end_.state().step();
    keep_horizons();
}

void WorkedCurves::hear(const event::Intersection& e) {
    const VisibilityFlag from = end_.state().values().place.previous->second,
                         to = end_.state().values().place.current->second;
    const VisibilityFlag side = e.at == Line::FH7 ? side_beside(from, to) : side_beside(to, from);
    curves_.back().meetings.push_back({e.point, side == VisibilityFlag::above});
}

void WorkedCurves::hear(const event::SideEdge& e) {
    if (e.at == Line::FH10) keep_horizons();
}

void WorkedCurves::keep_horizons() {
    curves_.back().upper = end_.state().values().horizons.upper;
    curves_.back().lower = end_.state().values().horizons.lower;
}

}  // namespace vidno::figures
