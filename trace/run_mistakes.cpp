#include "run_mistakes.h"

#include <cassert>

#include "recorder.h"
#include "vidno/mistakes.h"

namespace vidno {

namespace {

constexpr auto first_mistake = std::size_t(Edition::printed) + 1;

static_assert(std::apply(
                  [](auto... sets) {
                      auto place = first_mistake;
                      return ((edition_names[place++] == sets.name) && ...) && place == edition_names.size();
                  },
                  Mistakes{}),
              "the mistakes of the library are editions, in their order");

template <Kernel K>
Picture told(const RunRequest& request, const K& kernel, Detail detail, const Hear& hear) {
    const auto sink = [&](const auto& event) { hear(event); };
    Recording<const decltype(sink)> recording{detail, sink};
    const Recorder<K, const decltype(sink)> recorder(recording);
    std::optional<Picture> picture;
    const auto run_if_meant = [&]<class Set>(Set) {
        if (Set::name != choice_of(request.edition).name) return;
        picture = render<Set>(request.method, request.scene, kernel, recorder, request.smallest_window);
    };
    std::apply([&](auto... sets) { (run_if_meant(sets), ...); }, Mistakes{});
    assert(picture);
    return *std::move(picture);
}

}  // namespace

Picture told_mistake(const RunRequest& request, const Exact& kernel, const Hear& hear) {
    return told(request, kernel, Detail::signs, hear);
}

Picture told_mistake(const RunRequest& request, const Checked<Double>& kernel, const Hear& hear) {
    return told(request, kernel, Detail::signs, hear);
}

Picture run_mistake(const RunRequest& request) {
    const auto write = [&](const Event& event) {
        std::visit([&](const auto& each) { (*request.writer)(each); }, event);
    };
    const auto pace = [&](const Event& event) {
        if (std::holds_alternative<event::Pop>(event) || std::holds_alternative<event::Polygon>(event)) {
            request.progress();
        }
    };
    const Hear hear = request.writer ? Hear(write) : Hear(pace);
    const Detail detail = request.writer ? request.detail : Detail::windows;
    if (request.kernel.choice->run == run_exact) return told(request, Exact{}, detail, hear);
    assert(request.kernel.choice->run == run_double);
    return told(request, Double{}, detail, hear);
}

}  // namespace vidno
