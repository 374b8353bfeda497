#include "curve_run.h"

#include <cmath>

#include "checked.h"
#include "checked_trace.h"
#include "kernels.h"
#include "recorder.h"
#include "vidno/floating_horizon.h"
#include "vidno/kernels/filtered_heights.h"
#include "vidno/printed.h"

namespace vidno {

namespace {

template <class K>
constexpr bool takes_curves = !std::same_as<K, DepthBits> && !std::same_as<K, Grid>;

/// Calls `use` with the kernel, which takes curves.
DrawnLines with_curve_kernel(const NamedKernel& named, auto&& use) {
    return with_kernel(named, [&]<class K>(K kernel) -> DrawnLines {
        if constexpr (takes_curves<K>) {
            return use(kernel);
        } else {
            assert(false);
            return {};
        }
    });
}

template <class Set, Kernel K>
DrawnLines drawn_by(const CurveRequest& request, const K& kernel, auto trace) {
    const auto end = [](const auto& e) {
        return LineEnd<Value>{{as_value<K>(e.point.x), as_value<K>(e.point.y)}, e.left, e.right};
    };
    DrawnLines drawn;
    for (const auto& [segment, from, to] : visible_lines<Set>(request.scene, kernel, trace).lines) {
        drawn.push_back({segment, end(from), end(to)});
    }
    return drawn;
}

/// The lines of the request's edition; `trace_for` gives the visitor of a run by a set.
template <Kernel K>
DrawnLines drawn(const CurveRequest& request, const K& kernel, auto&& trace_for) {
    if constexpr (PrintedKernel<K>) {
        if (request.edition == Edition::printed) {
            return drawn_by<Printed>(request, kernel, trace_for.template operator()<Printed>());
        }
    }
    return drawn_by<Corrected>(request, kernel, trace_for.template operator()<Corrected>());
}

/// The visitor of a run without a trace.
struct CurvePacer : NoTrace {
    const std::function<void()>& progress;
    void curve(Line, int) { progress(); }
};

// What a height should be, along the path that was taken; none if it is undefined.
template <class T>
std::optional<Rational> truth_of(const Shadowed<T>& height) {
    return height.exact;
}
std::optional<Rational> truth_of(const Rational& height) { return height; }
std::optional<Rational> truth_of(const auto& height) requires requires { height.exactly(); }
{ return height.exactly(); }

/// What Visibility should say of heights.
template <class Set>
Truth true_flag(const auto& y, const auto& upper, const auto& lower) {
    using enum VisibilityFlag;
    const auto of = [](const auto& cell) { return cell ? truth_of(*cell) : std::nullopt; };
    const std::optional<Rational> height = truth_of(y), up = of(upper), low = of(lower);
    const bool undefined = !height || up.has_value() != upper.has_value() || low.has_value() != lower.has_value();
    if (undefined) return {};
    const OnColumns<Exact> exact;
    const bool reaches_upper = reaches_horizon(exact, *height, up, above);
    const bool reaches_lower = reaches_horizon(exact, *height, low, below);
    if (reaches_upper && reaches_lower) return {int(Set::flag_on_both())};
    if (reaches_upper) return {int(above)};
    return {int(reaches_lower ? below : hidden)};
}

/// Who follows a run that is judged. The verdicts on an event's decisions come before it.
struct Audience {
    Judge judge;
    Surveyor survey;
    std::function<void(FilterStage)> count;  // under `filtered`, what decided each comparison
    std::function<void(const Event&)> hear;
    bool in_visibility = false;  // there not each comparison is judged, but what comes of them
};

/// Records, and judges what Visibility says.
template <class Set, Kernel K, class Sink>
class JudgingRecorder : public Recorder<K, Sink> {
    using Base = Recorder<K, Sink>;

public:
    JudgingRecorder(Recording<Sink>& recording, Audience& audience) : Base(recording), audience_(&audience) {}

    void call(Line at, Procedure procedure) {
        audience_->in_visibility = procedure == Procedure::visibility;
        Base::call(at, procedure);
    }
    void height(Line at, int column, const auto& y, const auto& upper, const auto& lower) {
        truth_ = true_flag<Set>(y, upper, lower);
        Base::height(at, column, y, upper, lower);
    }
    void visibility(Line at, const auto& segment, int column, VisibilityFlag flag) {
        audience_->in_visibility = false;
        audience_->judge({Decision::visibility, int(flag), truth_});
        Base::visibility(at, segment, column, flag);
    }
    void intersection(Line at, const auto& segment, const auto& end) {
        if (!end.on_column()) survey(end.point);
        Base::intersection(at, segment, end);
    }

private:
    template <class T>
    void survey(const Point<Shadowed<T>>& p) {
        if (!p.x.exact || !p.y.exact || !std::isfinite(double(p.x)) || !std::isfinite(double(p.y))) return;
        const auto off = [](const auto& v) { return CGAL::to_double(Rational(double(v)) - *v.exact); };
        audience_->survey(std::hypot(off(p.x), off(p.y)));
    }
    void survey(const auto&) {}  // right, or rounded where nobody sees it

    Audience* audience_;
    Truth truth_;  // of the flag to come
};

/// The lines of a run that is judged.
DrawnLines judged_lines(const CurveRequest& request, Audience audience) {
    const Judge judge_comparison = [&](const Verdict& verdict) {
        if (!audience.in_visibility) audience.judge(verdict);
    };
    const auto lines = [&]<Kernel K>(const K& kernel) {
        const auto sink = [&](const auto& event) { audience.hear(event); };
        using Sink = const decltype(sink);
        Recording<Sink> recording{Detail::signs, sink};
        return drawn(request, kernel, [&]<class Set>() { return JudgingRecorder<Set, K, Sink>(recording, audience); });
    };
    return with_curve_kernel(request.kernel, [&]<class K>(const K& kernel) {
        if constexpr (std::same_as<K, Filtered>) {
            return lines(FilteredBy<StageTally>({&audience.count}));
        } else if constexpr (std::same_as<K, Exact>) {
            return lines(kernel);
        } else {
            return lines(Checked<K>(kernel, judge_comparison, audience.survey));
        }
    });
}

DrawnLines trace_checked(const CurveRequest& request) {
    CheckedTrace trace(request.detail, *request.writer);
    const auto judge = [&](const Verdict& verdict) { trace.judge(verdict); };
    const auto count = [&](FilterStage stage) { trace.count(stage); };
    const auto hear = [&](const Event& event) { trace.hear(event); };
    DrawnLines lines = judged_lines(request, {judge, [](double) {}, count, hear});
    trace.tell_wrong_ones();
    return lines;
}

}  // namespace

ColumnsDrawn columns_drawn(const DrawnLines& lines, const CurveScene& scene) {
    ColumnsDrawn drawn;
    for (const auto& [samples] : scene.curves) {
        drawn.emplace_back(std::size_t(samples.back().x - samples.front().x + 1), false);
    }
    for (const auto& [segment, from, to] : lines) {
        const auto curve = std::size_t(segment.curve);
        const int first = scene.curves[curve].samples.front().x;
        for (int x = from.right; x <= to.left; ++x) drawn[curve][std::size_t(x - first)] = true;
    }
    return drawn;
}

std::uint64_t different_columns(const ColumnsDrawn& one, const ColumnsDrawn& other) {
    std::uint64_t different = 0;
    for (std::size_t curve = 0; curve < one.size(); ++curve) {
        for (std::size_t i = 0; i < one[curve].size(); ++i) different += one[curve][i] == other[curve][i] ? 0 : 1;
    }
    return different;
}

DrawnLines run(const CurveRequest& request) {
    return with_curve_kernel(request.kernel, [&]<class K>(const K& kernel) {
        if (!request.writer) {
            return drawn(request, kernel, [&]<class>() { return CurvePacer{{}, request.progress}; });
        }
        Recording<TraceWriter> recording{request.detail, *request.writer};
        return drawn(request, kernel, [&]<class>() { return Recorder<K, TraceWriter>(recording); });
    });
}

CurveCheckReport check_run(const CurveRequest& request, const std::function<void(const Event&)>& hear) {
    DecisionCount counted(Procedure::floating_horizon);
    const auto judge = [&](const Verdict& verdict) { counted.judge(verdict); };
    const auto survey = [&](double pixels) { counted.survey(pixels); };
    const auto count = [&](FilterStage stage) { counted.count(stage); };
    const auto follow = [&](const Event& event) {
        request.progress();
        counted.follow(event);
        hear(event);
    };
    CurveCheckReport report;
    report.lines = judged_lines(request, {judge, survey, count, follow});
    static_cast<DecisionReport&>(report) = counted.report();

    const CurveRequest exactly{*kernel_named(Exact::name), Edition::corrected, request.scene};
    const auto found = columns_drawn(report.lines, request.scene);
    report.columns = column_count(request.scene);
    report.wrong_columns = different_columns(found, columns_drawn(run(exactly), request.scene));
    return report;
}

bool write_trace(CurveRequest request, TraceWriter& writer, bool checked) {
    request.writer = &writer;
    try {
        writer.finish("lines", lines_hash(checked ? trace_checked(request) : run(request)));
        return true;
    } catch (const EventLimitReached&) {
        writer.finish_partial();
        return false;
    }
}

}  // namespace vidno
