#include "run/recorder.h"
#include "run/run_time_kernel.h"
#include "run/traced.h"
#include "run/weiler_atherton_run.h"
#include "vidno/kernels/filtered_regions.h"

namespace vidno {

namespace {

/// An always right kernel that reports each sign, so that another run can be compared with it.
struct TellingSigns : FilteredBy<StageTally> {
    const HearSign* hear_sign;

    explicit TellingSigns(const Followers& followers)
        : FilteredBy<StageTally>(StageTally{followers.count}), hear_sign(followers.hear_sign) {}
};

struct NumbersTellingSigns : ConstructedNumbers<StageTally> {
    const HearSign* hear_sign;

    explicit NumbersTellingSigns(const TellingSigns& kernel)
        : ConstructedNumbers<StageTally>(kernel), hear_sign(kernel.hear_sign) {}

    Sign sign_of(const auto& formula, const auto&... values) const {
        const Sign taken = ConstructedNumbers<StageTally>::sign_of(formula, values...);
        if (hear_sign) (*hear_sign)(taken);
        return taken;
    }
    Sign sign(const Constructed& value) const { return sign_of(itself, value); }
};

template <Kernel K>
Picture traced_regions(const RunRequest& request, const K& kernel) {
    Recording recording{request.detail, *request.sink};
    return weiler_atherton_run(request, kernel, Recorder<K>(recording));
}

}  // namespace

template <>
struct OnRegions<TellingSigns> : OnRegions<NumbersTellingSigns> {
    explicit OnRegions(const TellingSigns& kernel) : OnRegions<NumbersTellingSigns>(NumbersTellingSigns(kernel)) {}
};

Picture traced_weiler_atherton(const RunRequest& request, const Followers& followers) {
    const KernelKind kind = request.kernel.kind();
    if (kind == KernelKind::filtered) return traced_regions(request, TellingSigns(followers));
    if (kind == KernelKind::binary64 && !followers.judge) return traced_regions(request, Double{});
    return traced_regions(request, RunTimeKernel(request.kernel, followers));
}

}  // namespace vidno
