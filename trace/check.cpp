#include "check.h"

#include <algorithm>
#include <array>

#include "check_family.h"
#include "checked.h"
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

/// Calls `take(event)` if the event tells a decision.
void if_decision(auto&& event, auto&& take) {
    std::visit(
        [&](auto& e) {
            if constexpr (requires { e.decides; }) take(e);
        },
        event);
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

/// Writes a judged run as a trace.
class CheckedTrace {
public:
    explicit CheckedTrace(const RunRequest& request) : request_(request) {}

    void judge(const Verdict& verdict) { verdicts_.push_back(verdict); }
    void count(FilterStage stage) { last_stage_ = std::max(last_stage_.value_or(stage), stage); }

    void hear(Event event) {
        if_decision(event, [&](auto& e) { e.told = {truth_of(e.decides), last_stage_}; });
        last_stage_.reset();
        std::visit([&](auto& e) { write(e); }, event);
        tell_wrong_ones();
    }

    /// Those after the last event.
    void tell_wrong_ones() {
        for (const auto& verdict : std::exchange(verdicts_, {})) {
            if (!verdict.wrong()) continue;
            write(event::Disagree{at_, verdict.of, verdict.taken, *verdict.truth.answer, verdict.cause()});
        }
    }

private:
    template <class E>
    void write(E& event) {
        at_ = event.at;
        if constexpr (std::same_as<E, event::Span>) {
            if (request_.detail < Detail::polygons) event.depths.reset();
        }
        Detail from = E::kind.from;
        if constexpr (std::same_as<E, event::Call>) from = event::calls_from(event.of);
        if (from <= request_.detail) (*request_.writer)(event);
    }
    void write(const event::Disagree& event) { (*request_.writer)(event); }

    /// The truth of the event's decision; of a span's columns from those of its ends. None if it was not judged.
    std::optional<Truth> truth_of(Decision decision) const {
        const auto found = [&](Decision of) -> const Truth* {
            const auto last = std::find_if(verdicts_.rbegin(), verdicts_.rend(), [&](auto& v) { return v.of == of; });
            return last == verdicts_.rend() ? nullptr : &last->truth;
        };
        if (const Truth* truth = found(decision)) return *truth;
        const Truth* first = found(Decision::first_centre);
        const Truth* last = found(Decision::last_centre);
        if (decision != Decision::columns || !first || !last) return std::nullopt;
        if (!first->answer || !last->answer) return Truth{};
        return Truth{std::pair(std::get<int>(*first->answer), std::get<int>(*last->answer) + 1)};
    }

    const RunRequest& request_;
    std::vector<Verdict> verdicts_;          // since the last event
    std::optional<FilterStage> last_stage_;  // that was needed since
    Line at_{};
};

}  // namespace

bool CheckReport::found_something() const {
    return wrong_pixels > 0 ||
           std::any_of(procedures.begin(), procedures.end(), [](const auto& each) { return each.first_wrong; });
}

Picture right_picture(const Scene& scene, Method method) {
    return run({reference_of(method), *kernel_named("exact"), Edition::corrected, scene});
}

CheckReport check_run(const RunRequest& request, const Picture& right, const std::function<void(const Event&)>& hear) {
    std::vector<Procedure> running{choice_of(request.method).procedure};
    std::array<ProcedureVerdicts, procedure_names.size()> verdicts;
    std::uint64_t steps = 0;
    CheckReport report{Picture(request.scene.area, request.scene.background)};

    const auto judge = [&](const Verdict& verdict) {
        auto& own = verdicts[std::size_t(running.back())];
        ++own.decisions;
        own.wrong_for_operands += verdict.right_for_operands ? 0 : 1;
        own.wrong_for_scene += verdict.wrong() ? 1 : 0;
        own.undefined += verdict.truth.answer ? 0 : 1;
        if ((verdict.wrong() || !verdict.right_for_operands) && !own.first_wrong) own.first_wrong = steps + 1;
    };
    const auto survey = [&](double pixels) {
        ++report.intersections;
        report.farthest_off = std::max(report.farthest_off, pixels);
    };
    const auto follow = [&](const Event& event) {
        ++steps;
        request.progress();
        hear(event);
        std::visit(
            [&]<class E>(const E& e) {
                if constexpr (std::same_as<E, event::Call>) running.push_back(e.of);
                if constexpr (requires { E::result_of; }) running.pop_back();
            },
            event);
    };
    const auto count = [&](FilterStage stage) { ++report.decided_by[std::size_t(stage)]; };
    report.picture = judged_run(request, {judge, survey, count, follow});
    report.wrong_pixels = different_pixels(report.picture, right);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        verdicts[i].procedure = Procedure(i);
        if (verdicts[i].decisions > 0) report.procedures.push_back(verdicts[i]);
    }
    return report;
}

Picture trace_checked(const RunRequest& request) {
    CheckedTrace trace(request);
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
