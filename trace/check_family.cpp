#include "check_family.h"

#include "recorder.h"
#include "vidno/family/family.h"

namespace vidno {

namespace {

template <Kernel K>
Picture told(const RunRequest& request, const K& kernel, const HearEvent& hear) {
    const auto sink = [&](const auto& event) { hear(event); };
    Recording<const decltype(sink)> recording{Detail::signs, sink};
    const Recorder<K, const decltype(sink)> recorder(recording);
    return family::with_set_of(request.method, [&]<class Set>(Set) {
        return render<Set>(request.method, request.scene, kernel, recorder, request.smallest_window);
    });
}

}  // namespace

Picture told_family(const RunRequest& request, const Checked<Float>& kernel, const HearEvent& hear) {
    return told(request, kernel, hear);
}
Picture told_family(const RunRequest& request, const Checked<Double>& kernel, const HearEvent& hear) {
    return told(request, kernel, hear);
}
Picture told_family(const RunRequest& request, const Checked<Bits>& kernel, const HearEvent& hear) {
    return told(request, kernel, hear);
}
Picture told_family(const RunRequest& request, const FilteredBy<StageTally>& kernel, const HearEvent& hear) {
    return told(request, kernel, hear);
}
Picture told_family(const RunRequest& request, const Grid& kernel, const HearEvent& hear) {
    return told(request, kernel, hear);
}
Picture told_family(const RunRequest& request, const Exact& kernel, const HearEvent& hear) {
    return told(request, kernel, hear);
}

}  // namespace vidno
