#include "run/run.h"

#include <stdexcept>

#include "run/untraced.h"

namespace vidno {

Picture told_to_nobody(RunRequest request) {
    HeardBy sink([progress = request.progress](const EventView& event) {
        if (event.get_if<event::Pop>() || event.get_if<event::Polygon>() || event.get_if<event::PopList>()) progress();
    });
    request.detail = Detail::windows;
    request.sink = &sink;
    return told_run(request);
}

Picture run(const RunRequest& request) {
    if (!request.kernel.choice->runs(request.method, request.edition)) {
        throw std::invalid_argument(request.kernel.name() + " does not run this method in this edition");
    }
    if (request.sink) return told_run(request);
    return is_compiled_untraced(request.edition) ? untraced_run(request) : told_to_nobody(request);
}

}  // namespace vidno
