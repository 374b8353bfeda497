#include "check.h"

#include "check_family.h"
#include "check_regions.h"
#include "checked.h"
#include "checked_trace.h"
#include "kernels.h"
#include "method.h"
#include "recorder.h"
#include "run_mistakes.h"
#include "vidno/printed.h"

namespace vidno {

namespace {

/// Who follows a run that is judged. The verdicts on an event's decisions come before it.
struct Audience {
    Judge judge;
    Surveyor survey;
    std::function<void(FilterStage)> count;  // under `filtered`, what decided each comparison
    std::function<void(const Event&)> hear;
};

template <Kernel K>
Picture told_run(const RunRequest& request, const K& kernel, const std::function<void(const Event&)>& hear) {
    if constexpr (requires { told_mistake(request, kernel, hear); }) {
        if (is_mistake(request.edition)) return told_mistake(request, kernel, hear);
    }
    if constexpr (requires { told_family(request, kernel, hear); }) {
        if (is_family(request.method)) return told_family(request, kernel, hear);
    }
    const auto sink = [&](const auto& event) { hear(event); };
    Recording<const decltype(sink)> recording{Detail::signs, sink};
    const Recorder<K, const decltype(sink)> recorder(recording);
    if constexpr (PrintedKernel<K>) {
        if (request.edition == Edition::printed) {
            return render<Printed>(request.method, request.scene, kernel, recorder, request.smallest_window);
        }
    }
    return render<Corrected>(request.method, request.scene, kernel, recorder, request.smallest_window);
}

/// A kernel that should always be right takes the decisions of the exact one, one after the other.
template <Kernel K>
Picture compared_run(const RunRequest& request, const K& kernel, const Audience& audience) {
    std::vector<Answer> right;
    told_run(request, Exact{},
             [&](const Event& event) { if_decision(event, [&](const auto& e) { right.push_back(e.decision()); }); });
    bool parted = false;
    return told_run(request, kernel, [&, next = std::size_t{0}](const Event& event) mutable {
        if_decision(event, [&](const auto& e) {
            Verdict verdict{e.decides, e.decision(), {}};
            if (!parted && next < right.size()) verdict.truth.answer = right[next++];
            parted = parted || verdict.wrong();
            verdict.right_for_operands = !verdict.wrong();
            audience.judge(verdict);
        });
        audience.hear(event);
    });
}

Picture judged_run(const RunRequest& request, const Audience& audience) {
    if (request.method == Method::weiler_atherton) {
        return judged_regions(request, audience.judge, audience.survey, audience.count, audience.hear);
    }
    const auto judged = [&](auto kernel) {
        using K = decltype(kernel);
        if constexpr (std::same_as<K, Filtered>) {
            return compared_run(request, FilteredBy<StageTally>({&audience.count}), audience);
        } else if constexpr (std::same_as<K, Grid> || std::same_as<K, Exact>) {
            return compared_run(request, kernel, audience);
        } else {
            return told_run(request, Checked<K>(kernel, audience.judge, audience.survey), audience.hear);
        }
    };
    return with_kernel(request.kernel, judged);
}

}  // namespace

Picture right_picture(const Scene& scene, Method method) {
    return run({reference_of(method), *kernel_named("exact"), Edition::corrected, scene});
}

CheckReport check_run(const RunRequest& request, const Picture& right, const std::function<void(const Event&)>& hear) {
    DecisionCount counted(choice_of(request.method).procedure);
    const auto judge = [&](const Verdict& verdict) { counted.judge(verdict); };
    const auto survey = [&](double pixels) { counted.survey(pixels); };
    const auto count = [&](FilterStage stage) { counted.count(stage); };
    const auto follow = [&](const Event& event) {
        request.progress();
        hear(event);
        counted.follow(event);
    };
    Picture picture = judged_run(request, {judge, survey, count, follow});
    const auto wrong_pixels = different_pixels(picture, right);
    return {counted.report(), std::move(picture), wrong_pixels};
}

Picture trace_checked(const RunRequest& request) {
    CheckedTrace trace(request.detail, *request.writer);
    const auto judge = [&](const Verdict& verdict) { trace.judge(verdict); };
    const auto count = [&](FilterStage stage) { trace.count(stage); };
    const auto hear = [&](const Event& event) { trace.hear(event); };
    Picture picture = judged_run(request, {judge, [](double) {}, count, hear});
    trace.tell_wrong_ones();
    return picture;
}

bool write_trace(RunRequest request, TraceWriter& writer, bool checked) {
    request.writer = &writer;
    try {
        writer.finish(checked ? trace_checked(request) : run(request));
        return true;
    } catch (const EventLimitReached&) {
        writer.finish_partial();
        return false;
    }
}

}  // namespace vidno
