#include <cmath>

#include "run/floating_horizon_lines.h"
#include "run/recorded_floating_horizon.h"
#include "run/recorder.h"
#include "run/run_time_kernel.h"
#include "vidno/kernels/filtered_heights.h"

namespace vidno {

namespace {

// What a height should be, along the path that was taken; none if it is undefined, or the run is not judged.
std::optional<Rational> truth_of(const RunTimeNumber& height) { return height.truth(); }
std::optional<Rational> truth_of(double) { return std::nullopt; }
std::optional<Rational> truth_of(const auto& height) { return height.exactly(); }

/// What Visibility should say of heights.
Truth true_flag(const auto& set, const auto& y, const auto& upper, const auto& lower) {
    using enum VisibilityFlag;
    const auto of = [](const auto& cell) { return cell ? truth_of(*cell) : std::nullopt; };
    const std::optional<Rational> height = truth_of(y), up = of(upper), low = of(lower);
    const bool undefined = !height || up.has_value() != upper.has_value() || low.has_value() != lower.has_value();
    if (undefined) return {};
    const OnColumns<Exact> exact;
    const bool reaches_upper = reaches_horizon(exact, *height, up, above);
    const bool reaches_lower = reaches_horizon(exact, *height, low, below);
    if (reaches_upper && reaches_lower) return {int(set.flag_on_both())};
    if (reaches_upper) return {int(above)};
    return {int(reaches_lower ? below : hidden)};
}

/// What followers hear of a run beside its events.
struct Judging {
    const Judge* judge;
    const Surveyor* survey;
    bool in_visibility = false;  // there not each comparison is judged, but what comes of them
};

/// Records; of a judged run, judges what Visibility says.
template <class Set, Kernel K>
class FloatingHorizonRecorder : public Recorder<K> {
    using Base = Recorder<K>;

public:
    FloatingHorizonRecorder(Recording& recording, Judging& judging, const Set& set)
        : Base(recording), judging_(&judging), set_(set) {}

    void call(Line at, Procedure procedure) {
        judging_->in_visibility = procedure == Procedure::visibility;
        Base::call(at, procedure);
    }
    void height(Line at, int column, const auto& y, const auto& upper, const auto& lower) {
        if (judging_->judge) truth_ = true_flag(set_, y, upper, lower);
        Base::height(at, column, y, upper, lower);
    }
    void visibility(Line at, const auto& segment, int column, VisibilityFlag flag) {
        judging_->in_visibility = false;
        if (judging_->judge) (*judging_->judge)({Decision::visibility, int(flag), truth_});
        Base::visibility(at, segment, column, flag);
    }
    void intersection(Line at, const auto& segment, const auto& end) {
        if (judging_->survey && !end.on_column()) survey(end.point);
        Base::intersection(at, segment, end);
    }

private:
    void survey(const Point<RunTimeNumber>& p) {
        const auto known = [](const auto& v) { return !v.is_exact() && v.has_truth() && std::isfinite(v.value()); };
        if (!known(p.x) || !known(p.y)) return;
        const auto off = [](const auto& v) { return CGAL::to_double(Rational(v.value()) - *v.truth()); };
        (*judging_->survey)(std::hypot(off(p.x), off(p.y)));
    }
    void survey(const auto&) {}  // right, or rounded where nobody sees it

    Judging* judging_;
    Set set_;
    Truth truth_;  // of the flag to come
};

template <Kernel K>
DrawnLines told(const FloatingHorizonRequest& request, const K& kernel, Judging& judging) {
    Recording recording{request.detail, *request.sink};
    const auto by = [&]<class Set>(const Set& set) {
        return lines_drawn(request, kernel, FloatingHorizonRecorder<Set, K>(recording, judging, set), set);
    };
    if constexpr (PrintedKernel<K>) {
        return by(AnyFloatingHorizon(request.edition));
    } else {
        return by(CorrectedFloatingHorizon{});
    }
}

}  // namespace

DrawnLines told_floating_horizon(const FloatingHorizonRequest& request, const Followers& followers) {
    assert(request.sink);
    Judging judging{followers.judge, followers.survey};
    const KernelKind kind = request.kernel.kind();
    if (kind == KernelKind::filtered) return told(request, FilteredBy(StageTally{followers.count}), judging);
    if (kind == KernelKind::binary64 && !followers.judge) return told(request, Double{}, judging);
    const Judge judge_comparison = [&](const Verdict& verdict) {
        if (!judging.in_visibility) (*followers.judge)(verdict);
    };
    const bool judged = followers.judge && kind != KernelKind::exact;
    return told(request, RunTimeKernel(request.kernel, {.judge = judged ? &judge_comparison : nullptr}), judging);
}

}  // namespace vidno
