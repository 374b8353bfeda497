#include "chart/surface_chart.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "chart/chart.h"
#include "chart/chart_pictures.h"
#include "chart/timing.h"
#include "check/check.h"
#include "vidno/floating_horizon.h"

namespace vidno {

const CostAxes<SurfaceChartRun, 3> surface_cost_axes{{
    {"time", [](const SurfaceChartRun& run) { return std::optional(run.cost.time); }},
    {"operations", [](const SurfaceChartRun& run) { return std::optional(run.cost.operations); }},
    {"samples", [](const SurfaceChartRun& run) { return std::optional(run.cost.samples); }},
}};

const ErrorAxes<SurfaceChartRun, 3> surface_error_axes{{
    {"wrongColumns", [](const SurfaceChartRun& run) { return double(run.found.wrong_columns); }},
    {"height", [](const SurfaceChartRun& run) { return run.found.height; }},
    wrong_decisions_axis<SurfaceChartRun>,
}};

namespace {

/// The settings of a knob, from few samples to many.
struct Turn {
    std::optional<SamplingKnob> knob{};
    double value = 0;
};

std::vector<Turn> turns_for(const FunctionSurface& surface) {
    constexpr double coarsest = 16, finest = 1. / 16;  // pixels
    std::vector<Turn> turns{{}};
    const int columns = surface.view.across.columns;
    for (int parts = 1; parts < columns; parts *= 2) turns.push_back({SamplingKnob::samples, parts + 1.});
    turns.push_back({SamplingKnob::samples, columns + 1.});
    for (double tolerance = coarsest; tolerance >= finest; tolerance /= 2) {
        turns.push_back({SamplingKnob::tolerance, tolerance});
    }
    return turns;
}

FunctionSurface turned(FunctionSurface surface, const SurfaceWay& way) {
    if (way.knob == SamplingKnob::samples) {
        surface.samples = int(way.value);
        surface.tolerance.reset();
    } else if (way.knob == SamplingKnob::tolerance) {
        surface.samples = 2;
        surface.tolerance = way.value;
    }
    return surface;
}

/// The farthest that a curve is from the same one with a sample on each column, in pixels, where both have points.
double height_missed(const Curve& curve, const Curve& dense) {
    const OnColumns<Double> heights;
    double farthest = 0;
    auto from = curve.samples.begin();
    for (const Sample& sample : dense.samples) {
        if (std::next(from)->x < sample.x) ++from;
        const Segment segment{0, *from, *std::next(from)};
        if (!sample.has_point() || !segment.from.has_point() || !segment.to.has_point()) continue;
        farthest = std::max(farthest, std::abs(heights.height(segment, sample.x) - sample.y));
    }
    return farthest;
}

/// Counts the operations of an event; most have none.
struct Counting {
    FloatingHorizonOperationCounts& counts;

    void operator()(const event::Visibility&) const { add(FloatingHorizonOperation::visibilities, 1); }
    void operator()(const event::Horizon& e) const {
        add(FloatingHorizonOperation::horizons, std::max(0, e.last - e.first + 1));
    }
    void operator()(const event::Step&) const { add(FloatingHorizonOperation::steps, 1); }
    void operator()(const event::Intersection& e) const {
        add(FloatingHorizonOperation::crossings, e.columns.first < e.columns.second ? 1 : 0);
    }
    void operator()(const auto&) const {}

    void add(FloatingHorizonOperation operation, int count) const {
        counts[std::size_t(operation)] += std::uint64_t(count);
    }
};

/// The function as the screen shows it, with which runs of samples are compared.
class FunctionExaminer {
public:
    explicit FunctionExaminer(const Function& function)
        : dense_(admit(CurveScene{function.area, sampled(on_each_column(function.surface))})),
          lines_(run({kernel_of(KernelKind::filtered), Edition::corrected, dense_})),
          drawn_(columns_drawn(lines_, dense_)) {}

    const AdmittedCurves& dense() const { return dense_; }
    const DrawnLines& lines() const { return lines_; }

    SurfaceFindings examine(const FloatingHorizonRequest& request) const {
        SurfaceFindings found;
        const auto hear = [&](const EventView& event) { event.visit(Counting{found.operations}); };
        const FloatingHorizonCheckReport report = check_run(request, hear);
        for (const auto& each : report.procedures) {
            found.decisions += each.decisions - each.undefined;
            found.wrong_decisions += each.wrong_for_scene;
        }
        found.lines = report.lines;
        found.wrong_columns = different_columns(columns_drawn(report.lines, request.scene), drawn_);
        for (std::size_t i = 0; i < dense_->curves.size(); ++i) {
            found.height = std::max(found.height, height_missed(request.scene->curves[i], dense_->curves[i]));
        }
        return found;
    }

private:
    AdmittedCurves dense_;
    DrawnLines lines_;
    ColumnsDrawn drawn_;
};

}  // namespace

std::vector<SurfaceWay> ways_to_draw(const FunctionSurface& surface) {
    std::vector<SurfaceWay> ways;
    for (const auto& choice : kernel_choices) {
        for (const Edition edition : {Edition::corrected, Edition::printed}) {
            if (choice.parameter || !choice.runs_floating_horizon(edition)) continue;
            for (const auto& [knob, value] : turns_for(surface)) ways.push_back({{&choice}, edition, knob, value});
        }
    }
    return ways;
}

std::size_t turns_of(const Function& function) { return ways_to_draw(function.surface).size() * (1 + chart_rounds); }

SurfaceChart chart_of(const Function& function, const std::function<void()>& progress) {
    const FunctionExaminer examiner(function);
    SurfaceChart chart{function.name, examiner.dense()->curves.size(), column_count(examiner.dense())};
    chart.surface = function.file;
    const auto ways = ways_to_draw(function.surface);
    std::vector<AdmittedCurves> scenes;
    for (const SurfaceWay& way : ways)
        scenes.push_back(admit(CurveScene{function.area, sampled(turned(function.surface, way))}));
    SurfacePictures pictures(function.area, examiner.lines());
    std::vector<std::function<void()>> runs;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const FloatingHorizonRequest request{ways[i].kernel, ways[i].edition, scenes[i]};
        SurfaceFindings found = examiner.examine(request);
        SurfaceCost cost;
        cost.operations = double(std::accumulate(found.operations.begin(), found.operations.end(), std::uint64_t{0}));
        cost.samples = double(sample_count(scenes[i]));
        const std::size_t picture = pictures.place_of(std::exchange(found.lines, {}));
        chart.runs.push_back({ways[i], cost, found, {}, picture});
        runs.emplace_back([request] { run(request); });
        progress();
    }
    const auto seconds = median_seconds(runs, chart_rounds, progress);
    for (std::size_t i = 0; i < seconds.size(); ++i) chart.runs[i].cost.seconds = seconds[i];
    chart.pictures = pictures.json();
    compare_runs(chart.runs, surface_cost_axes, surface_error_axes);
    return chart;
}

}  // namespace vidno
