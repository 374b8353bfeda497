#include "check/check.h"

#include "check/judged_run.h"
#include "choice/method.h"

namespace vidno {

namespace {

/// Builds the report of a judged run while it runs.
class Report {
public:
    Report(Procedure method, const std::function<void()>& progress, const HearEvent& hear, FindingList* findings)
        : counted_(method), progress_(progress), hear_(hear), findings_(findings) {}

    Followers followers() const { return {&judge_, &survey_, &count_}; }
    EventSink& sink() { return sink_; }
    DecisionReport decisions() { return counted_.report(); }

private:
    DecisionCount counted_;
    const std::function<void()>& progress_;
    const HearEvent& hear_;
    FindingList* findings_;
    Judge judge_ = [this](const Verdict& verdict) {
        counted_.judge(verdict);
        if (findings_) findings_->judge(verdict);
    };
    Surveyor survey_ = [this](const Surveyed& point) {
        counted_.survey(point);
        if (findings_) findings_->survey(point);
    };
    StageCount count_ = [this](FilterStage stage) { counted_.count(stage); };
    FunctionSink<HearEvent> sink_{[this](const EventView& event) {
        progress_();
        hear_(event);
        counted_.follow(event);
        if (findings_) findings_->follow(event);
    }};
};

}  // namespace

Picture right_picture(const AdmittedScene& scene, Method method) {
    return run({reference_of(method), kernel_of(KernelKind::exact), Edition::corrected, scene});
}

CheckReport check_run(const RunRequest& request, const Picture& right, const HearEvent& hear, FindingList* findings) {
    const bool is_always_right = request.kernel.is_always_right();
    if (is_always_right && findings) find_in(request, *findings);
    Report report(choice_of(request.method).procedure, request.progress, hear, is_always_right ? nullptr : findings);
    RunRequest judged = request;
    judged.detail = Detail::signs;
    judged.sink = &report.sink();
    Picture picture = judged_run(judged, report.followers());
    const auto wrong_pixels = different_pixels(picture, right);
    return {report.decisions(), std::move(picture), wrong_pixels};
}

FloatingHorizonCheckReport check_run(const FloatingHorizonRequest& request, const HearEvent& hear,
                                     FindingList* findings) {
    Report report(Procedure::floating_horizon, request.progress, hear, findings);
    FloatingHorizonRequest judged = request;
    judged.detail = Detail::signs;
    judged.sink = &report.sink();
    DrawnLines lines = traced_floating_horizon(judged, report.followers());
    const FloatingHorizonRequest exactly{kernel_of(KernelKind::exact), Edition::corrected, request.scene};
    const auto wrong =
        different_columns(columns_drawn(lines, request.scene), columns_drawn(run(exactly), request.scene));
    return {report.decisions(), std::move(lines), column_count(request.scene), wrong};
}

}  // namespace vidno
