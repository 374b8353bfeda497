#include <cmath>

#include "run/floating_horizon_lines.h"
#include "run/machine_kernel.h"
#include "run/recorded_floating_horizon.h"
#include "run/recorder.h"
#include "run/run_time_kernel.h"
#include "vidno/kernels/filtered_heights.h"

namespace vidno {

namespace {

// The true height along the path that was taken; none if it is undefined, or the run is not judged.
std::optional<Rational> truth_of(const RunTimeNumber& height) { return height.truth(); }
std::optional<Rational> truth_of(float) { return std::nullopt; }
std::optional<Rational> truth_of(double) { return std::nullopt; }
std::optional<Rational> truth_of(const MachineNumber&) { return std::nullopt; }
std::optional<Rational> truth_of(const auto& height) { return height.exactly(); }

/// A height in use, and the true one.
struct JudgedHeight {
    double used;
    std::optional<Rational> exact;

    Operand operand(std::string name) const {
        return {std::move(name), fraction_of(used), {exact ? Exact::fraction(*exact) : ""}};
    }
};
/// The value of an exact number is a fraction.
bool is_exact(const RunTimeNumber& height) { return height.is_exact(); }
bool is_exact(const auto&) { return false; }

/// The decision of Visibility, from the height of the curve and those of the horizons, where these exist.
class HeightsCompared final : public Calculator {
public:
    HeightsCompared() = default;
    HeightsCompared(const auto& y, const auto& upper, const auto& lower, int digits)
        : y_{double(y), truth_of(y)},
          upper_(judged(upper)),
          lower_(judged(lower)),
          is_exact_(is_exact(y)),
          digits_(digits) {}

    /// The right flag.
    Truth true_flag(const auto& set) const {
        using enum VisibilityFlag;
        const auto undefined = [](const auto& of) { return of && !of->exact; };
        if (!y_.exact || undefined(upper_) || undefined(lower_)) return {};
        const auto height = [](const auto& of) { return of ? of->exact : std::nullopt; };
        const OnColumns<Exact> exact;
        const bool reaches_upper = reaches_horizon(exact, *y_.exact, height(upper_), above);
        const bool reaches_lower = reaches_horizon(exact, *y_.exact, height(lower_), below);
        if (reaches_upper && reaches_lower) return {int(set.flag_on_both())};
        if (reaches_upper) return {int(above)};
        return {int(reaches_lower ? below : hidden)};
    }

    Operands operands() const override {
        Operands found{operand(y_, "y")};
        if (upper_) found.push_back(operand(*upper_, "upper"));
        if (lower_) found.push_back(operand(*lower_, "lower"));
        return found;
    }
    std::optional<Gap> gap() const override {
        std::optional<Gap> nearest;
        for (const auto* horizon : {&upper_, &lower_}) {
            if (!*horizon || !(*horizon)->exact || !y_.exact) continue;
            Gap found = gap_of(Coincidence::curve_on_horizon, *y_.exact, *(*horizon)->exact, digits_);
            found.computed = is_exact_ ? Value(found.exact.text) : Value(y_.used - (*horizon)->used);
            if (!nearest || found.ulps < nearest->ulps) nearest = found;
        }
        return nearest;
    }

private:
    static std::optional<JudgedHeight> judged(const auto& cell) {
        return cell ? std::optional(JudgedHeight{double(*cell), truth_of(*cell)}) : std::nullopt;
    }
    Operand operand(const JudgedHeight& height, std::string name) const {
        Operand found = height.operand(std::move(name));
        if (is_exact_) found.used = found.exact;
        return found;
    }

    JudgedHeight y_{};
    std::optional<JudgedHeight> upper_, lower_;
    bool is_exact_ = false;
    int digits_ = 0;
};

/// The receivers of verdicts and constructed points.
struct Judging {
    const Judge* judge;
    const Surveyor* survey;
    int digits = 0;              // of the run's numbers
    bool in_visibility = false;  // there the flag is judged, not each comparison
};

/// Records; in a judged run, judges the flags of Visibility.
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
        if (judging_->judge) heights_ = HeightsCompared(y, upper, lower, judging_->digits);
        Base::height(at, column, y, upper, lower);
    }
    void visibility(Line at, const auto& segment, int column, VisibilityFlag flag) {
        judging_->in_visibility = false;
        if (judging_->judge) {
            (*judging_->judge)({Decision::visibility, int(flag), heights_.true_flag(set_), true, &heights_});
        }
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
        const auto off = [](const auto& v) { return nearest_double(Rational(v.value()) - *v.truth()); };
        const PointConstructed constructed(p.x, p.y);
        (*judging_->survey)({std::hypot(off(p.x), off(p.y)), &constructed});
    }
    void survey(const auto&) {}  // right, or rounded invisibly

    Judging* judging_;
    Set set_;
    HeightsCompared heights_;  // of the flag to come
};

template <Kernel K>
DrawnLines traced(const FloatingHorizonRequest& request, const K& kernel, Judging& judging) {
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

DrawnLines traced_floating_horizon(const FloatingHorizonRequest& request, const Followers& followers) {
    assert(request.sink);
    const KernelKind kind = request.kernel.kind();
    const int digits =
        kind == KernelKind::filtered ? std::numeric_limits<double>::digits : Arithmetic::of(request.kernel).digits();
    Judging judging{followers.judge, followers.survey, digits};
    if (kind == KernelKind::filtered) return traced(request, FilteredBy(StageTally{followers.count}), judging);
    if (!followers.judge) {
        if (kind == KernelKind::binary32) return traced(request, Float{}, judging);
        if (kind == KernelKind::binary64) return traced(request, Double{}, judging);
        if (kind == KernelKind::bits) return traced(request, MachineKernel(request.kernel), judging);
    }
    const Judge judge_comparison = [&](const Verdict& verdict) {
        if (!judging.in_visibility) (*followers.judge)(verdict);
    };
    const bool judged = followers.judge && kind != KernelKind::exact;
    return traced(request, RunTimeKernel(request.kernel, {.judge = judged ? &judge_comparison : nullptr}), judging);
}

}  // namespace vidno
