#include "run_mistakes.h"

#include <algorithm>
#include <cassert>

#include "recorder.h"
#include "vidno/mistakes.h"

namespace vidno {

namespace {

/// The edition of a set's name.
template <class Set>
constexpr auto edition_of = Edition(std::find(edition_names.begin(), edition_names.end(), Set::name) -
                                    edition_names.begin());

template <Kernel K>
Picture told(const RunRequest& request, const K& kernel, Detail detail, const Hear& hear) {
    const auto sink = [&](const auto& event) { hear(event); };
    Recording<const decltype(sink)> recording{detail, sink};
    const Recorder<K, const decltype(sink)> recorder(recording);
    std::optional<Picture> picture;
    const auto run_if_meant = [&]<class Set>(Set) {
        if (request.edition != edition_of<Set>) return;
        constexpr auto only = choice_of(edition_of<Set>).only;  // of a method that has it not, nothing is compiled
        picture = render<Set>(only.value_or(request.method), request.scene, kernel, recorder, request.smallest_window);
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
