#include "run/run.h"

#include <stdexcept>

#include "run/untraced.h"

namespace vidno {

Picture run_and_discard_trace(RunRequest request) {
    RunLosses losses(request.kernel.name());
    FunctionSink sink([&](const EventView& event) {
        if (event.get_if<event::Pop>() || event.get_if<event::Polygon>() || event.get_if<event::PopList>()) {
            request.progress();
        }
        if (request.loses != nullptr) losses.hear(event);
    });
    request.detail = request.loses != nullptr ? Detail::polygons : Detail::windows;  // planes from level polygons on
    request.sink = &sink;
    Picture picture = traced_run(request);
    if (request.loses != nullptr) *request.loses = losses.any();
    return picture;
}

std::vector<Loss> losses_of(RunRequest request) {
    RunLosses losses(request.kernel.name());
    FunctionSink sink([&](const EventView& event) { losses.hear(event); });
    request.detail = Detail::signs;
    request.sink = &sink;
    request.regions = nullptr;
    traced_run(request);
    return losses.all(polygon_names(request.scene));
}

Picture run(const RunRequest& request) {
    if (!request.kernel.choice->runs(request.method, request.edition)) {
        throw std::invalid_argument(request.kernel.name() + " does not run this method in this edition");
    }
    if (request.sink) return traced_run(request);
    return is_compiled_untraced(request.edition) ? untraced_run(request) : run_and_discard_trace(request);
}

}  // namespace vidno
