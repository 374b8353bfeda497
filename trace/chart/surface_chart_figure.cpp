// The figure of a chart of surfaces.

#include "chart/surface_chart.h"
#include "scene/scene_names.h"

namespace vidno {

const InEachLanguage<SurfaceChartWords> surface_chart_words{
    {.costs = {"time, times that of the fastest", "operations", "samples"},
     .errors = {"wrong columns, %", "height missed, pixels", "wrong decisions, %"},
     .knobs = {"samples", "tolerance"},
     .as_given = "as given",
     .printed = "printed",
     .front = "nothing is cheaper and as right"},
    {.costs = {"время относительно самого быстрого прогона", "операции", "отсчёты"},
     .errors = {"неверные столбцы, %", "потерянная высота, пиксели", "неверные решения, %"},
     .knobs = {"отсчёты", "допуск"},
     .as_given = "как задано",
     .printed = "как напечатано",
     .front = "дешевле и не хуже ничего нет"}};

namespace {

/// Runs that are drawn in the same style. Each kernel has a colour, each knob and edition a shape.
struct SurfaceSeries {
    std::string_view kernel;
    Edition edition;
    std::optional<SamplingKnob> knob;

    bool has(const SurfaceWay& way) const {
        return way.kernel.choice->name == kernel && way.edition == edition && way.knob == knob;
    }
    std::string name(const SurfaceChartWords& words) const {
        std::string text(knob ? words.knobs[std::size_t(*knob)] : words.as_given);
        text += ", ";
        text += kernel;
        return edition == Edition::printed ? text + ", " + std::string(words.printed) : text;
    }
    /// By the index of the kernel among those without a parameter.
    std::string_view color() const {
        constexpr std::array<std::string_view, 5> colors{"#0072b2", "#d55e00", "#009e73", "#000000", "#cc79a7"};
        std::size_t place = 0;
        for (const auto& choice : kernel_choices) {
            if (choice.name == kernel) break;
            if (!choice.parameter) ++place;
        }
        return colors[place % colors.size()];
    }
    int point() const {
        const int filled = edition == Edition::corrected ? 1 : 0;  // gnuplot has each shape open, and next to it filled
        if (!knob) return 12 + filled;
        return (*knob == SamplingKnob::samples ? 4 : 6) + filled;
    }
};

/// Over all runs of any surface.
std::vector<SurfaceSeries> all_surface_series() {
    std::vector<SurfaceSeries> series;
    for (const auto& choice : kernel_choices) {
        for (const Edition edition : {Edition::corrected, Edition::printed}) {
            if (choice.parameter || !choice.runs_floating_horizon(edition)) continue;
            series.push_back({choice.name, edition, std::nullopt});
            for (const SamplingKnob knob : {SamplingKnob::samples, SamplingKnob::tolerance}) {
                series.push_back({choice.name, edition, knob});
            }
        }
    }
    return series;
}

/// In per cent, or in pixels.
double error_in(const SurfaceChart& surface, const SurfaceChartRun& run, std::size_t error) {
    const auto& axis = surface_error_axes[error];
    const double value = axis.of(run);
    if (axis.name == "height") return value;
    return 100 * (axis.name == "wrongDecisions" ? value : value / double(surface.columns));
}

Plot plot_of(const SurfaceChart& surface, std::size_t cost, std::size_t error, Language language) {
    Plot plot;
    plot.title = name_in(language, surface.name);
    const auto marks = [&](const auto& belongs) {
        std::vector<PlotMark> found;
        for (const auto& run : surface.runs) {
            if (belongs(run)) found.push_back({*surface_cost_axes[cost].of(run), error_in(surface, run, error)});
        }
        return found;
    };
    for (const auto& run : surface.runs) plot.errors.push_back(error_in(surface, run, error));
    for (const auto& series : all_surface_series()) {
        plot.marks.push_back(marks([&](const SurfaceChartRun& run) { return series.has(run.way); }));
    }
    plot.front = marks([&](const SurfaceChartRun& run) { return run.on_front[cost][error]; });
    return plot;
}

}  // namespace

std::string chart_script(const std::vector<SurfaceChart>& surfaces, std::size_t cost, std::size_t error,
                         const PlotLayout& layout, Language language) {
    const SurfaceChartWords& words = surface_chart_words.in(language);
    PlotWords of_plot{.cost = words.costs[cost],
                      .error = words.errors[error],
                      .front = words.front,
                      .no_number = {},
                      .series = {},
                      .plain_costs = surface_cost_axes[cost].name == "time"};
    for (const auto& series : all_surface_series()) {
        of_plot.series.push_back({series.name(words), series.color(), series.point(), series.knob.has_value()});
    }
    std::vector<Plot> plots;
    for (const auto& surface : surfaces) plots.push_back(plot_of(surface, cost, error, language));
    return plot_script(plots, of_plot, layout);
}

}  // namespace vidno
