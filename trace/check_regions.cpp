#include "check_regions.h"

#include "checked_regions.h"
#include "recorder.h"
#include "vidno/kernels/bits.h"
#include "vidno/kernels/filtered_regions.h"
#include "vidno/weiler_atherton.h"

namespace vidno {

Picture judged_regions(const RunRequest& request, const Judge& judge, const Surveyor& survey,
                       const std::function<void(FilterStage)>& count, const std::function<void(const Event&)>& hear) {
    const auto told = [&]<Kernel K>(const K& kernel) {
        const auto sink = [&](const auto& event) { hear(event); };
        Recording<const decltype(sink)> recording{Detail::signs, sink};
        return visible_regions(request.scene, kernel, Recorder<K, const decltype(sink)>(recording)).picture;
    };
    const auto checked = [&](auto machine) { return told(Checked(machine, judge, survey)); };
    // What should always be right takes the signs of the exact kernel, one after the other.
    const auto compared = [&](auto always_right) {
        std::vector<Sign> right;
        const HearSign keep = [&](Sign sign) { right.push_back(sign); };
        visible_regions(request.scene, TellingSigns(Exact{}, keep));
        bool parted = false;
        const HearSign compare = [&, next = std::size_t{0}](Sign sign) mutable {
            Verdict verdict{Decision::comparison, int(sign), {}};
            if (!parted && next < right.size()) verdict.truth.answer = int(right[next++]);
            parted = parted || verdict.wrong();
            verdict.right_for_operands = !verdict.wrong();
            judge(verdict);
        };
        return told(TellingSigns(always_right, compare));
    };

    const NamedKernel& kernel = request.kernel;
    if (kernel.choice->run == run_float) return checked(Float{});
    if (kernel.choice->run == run_double) return checked(Double{});
    if (kernel.choice->run == run_bits) return checked(Bits(kernel.parameter));
    if (kernel.choice->run == run_filtered) return compared(FilteredBy(StageTally{&count}));
    assert(kernel.choice->run == run_exact);
    return compared(Exact{});
}

}  // namespace vidno
