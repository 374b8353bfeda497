// The figure of a chart of scenes.

#include <algorithm>

#include "chart/chart.h"
#include "choice/method.h"
#include "scene/scene_names.h"

namespace vidno {

const InEachLanguage<ChartWords> chart_words{
    {.costs = {"time, times that of the fastest", "operations", "operations times bits"},
     .errors = {"wrong pixels, %", "area that differs, %", "wrong decisions, %", "depth error, ulps"},
     .series = {"Warnock, bits of arithmetic", "Warnock, grid", "Warnock, smallest window", "Warnock",
                "Warnock, printed", "Z-buffer, bits of arithmetic", "Z-buffer, grid", "Z-buffer, bits of depth",
                "Z-buffer", "Z-buffer, printed"},
     .of_family = "Warnock, ",
     .front = "nothing is cheaper and as right",
     .ordinary = "ordinary",
     .degenerate = "degenerate",
     .no_number = "no number"},
    {.costs = {"время относительно самого быстрого прогона", "операции", "операции × биты"},
     .errors = {"неверные пиксели, %", "площадь расхождения, %", "неверные решения, %", "ошибка глубины, ulp"},
     .series = {"Варнок, биты арифметики", "Варнок, сетка", "Варнок, наименьшее окно", "Варнок",
                "Варнок, как напечатано", "Z-буфер, биты арифметики", "Z-буфер, сетка", "Z-буфер, биты глубины",
                "Z-буфер", "Z-буфер, как напечатано"},
     .of_family = "Варнок, ",
     .front = "дешевле и не хуже ничего нет",
     .ordinary = "обычная",
     .degenerate = "вырожденная",
     .no_number = "не число"}};

namespace {

/// Runs that are drawn in the same style: as a line along a knob, otherwise as points.
struct Series {
    Method method;
    std::optional<Knob> knob;
    Edition edition;
    std::string_view color;  // from Okabe and Ito's palette for colour-blind readers
    int point;               // gnuplot's number for a shape

    bool operator==(const Series&) const = default;
    bool has(const Way& way) const { return way.method == method && way.knob == knob && way.edition == edition; }
};

constexpr std::array<Series, 10> course_series{{
    {Method::warnock, Knob::bits, Edition::corrected, "#0072b2", 9},
    {Method::warnock, Knob::grid, Edition::corrected, "#56b4e9", 11},
    {Method::warnock, Knob::window, Edition::corrected, "#cc79a7", 13},
    {Method::warnock, std::nullopt, Edition::corrected, "#000000", 5},
    {Method::warnock, std::nullopt, Edition::printed, "#000000", 4},
    {Method::zbuffer, Knob::bits, Edition::corrected, "#d55e00", 8},
    {Method::zbuffer, Knob::grid, Edition::corrected, "#e69f00", 10},
    {Method::zbuffer, Knob::depth, Edition::corrected, "#009e73", 12},
    {Method::zbuffer, std::nullopt, Edition::corrected, "#000000", 7},
    {Method::zbuffer, std::nullopt, Edition::printed, "#000000", 6},
}};

/// The other methods: each has a colour and a shape by its index.
std::vector<Series> all_series() {
    constexpr std::array<std::string_view, 3> colors{"#0072b2", "#cc79a7", "#009e73"};
    constexpr int shapes = 3;
    std::vector<Series> series(course_series.begin(), course_series.end());
    for (std::size_t i = 0, place = 0; i < method_names.size(); ++i) {
        if (is_of_course(Method(i))) continue;
        const std::string_view color = colors[place / shapes % colors.size()];
        series.push_back({Method(i), std::nullopt, Edition::corrected, color, int(place % shapes) + 1});
        ++place;
    }
    return series;
}

std::string name_of(const Series& series, Language language) {
    const ChartWords& words = chart_words.in(language);
    const auto of_course = std::find(course_series.begin(), course_series.end(), series);
    if (of_course != course_series.end()) return std::string(words.series[of_course - course_series.begin()]);
    const std::string title(choice_of(series.method).title.in(language));
    return is_family(series.method) ? std::string(words.of_family) + title : title;
}

/// In per cent, or in ulps.
double error_in(const SceneChart& scene, const ChartRun& run, std::size_t error) {
    const auto& axis = error_axes[error];
    const double value = axis.of(run);
    if (axis.name == "depthUlps") return value;
    return 100 * (axis.name == "wrongDecisions" ? value : value / double(scene.pixels));
}

Plot plot_of(const SceneChart& scene, std::size_t cost, std::size_t error, Language language) {
    const ChartWords& words = chart_words.in(language);
    Plot plot;
    plot.title = name_in(language, scene.name) + " (" +
                 std::string(scene.degenerate() ? words.degenerate : words.ordinary) + ")";
    const auto marks = [&](const auto& belongs) {
        std::vector<PlotMark> found;
        for (const auto& run : scene.runs) {
            const auto own_cost = cost_axes[cost].of(run);
            if (!own_cost || !belongs(run)) continue;
            found.push_back({*own_cost, error_in(scene, run, error), std::string(run.way.kernel.choice->name)});
        }
        return found;
    };
    for (const auto& run : scene.runs) plot.errors.push_back(error_in(scene, run, error));
    for (const auto& series : all_series()) {
        plot.marks.push_back(marks([&](const ChartRun& run) { return series.has(run.way); }));
        // The kernels of the corrected text are named beside their points.
        // The variants of Warnock's algorithm lie so close that their kernels' names would cover one another.
        const bool named = !series.knob && series.edition == Edition::corrected && !is_family(series.method);
        if (named) plot.labels.push_back({plot.marks.back(), is_warnock(series.method)});
    }
    plot.front = marks([&](const ChartRun& run) { return run.on_front[cost][error]; });
    return plot;
}

PlotWords plot_words(std::size_t cost, std::size_t error, Language language) {
    const ChartWords& words = chart_words.in(language);
    PlotWords of_plot{.cost = words.costs[cost],
                      .error = words.errors[error],
                      .front = words.front,
                      .no_number = words.no_number,
                      .series = {},
                      .plain_costs = cost_axes[cost].name == "time"};
    for (const auto& series : all_series()) {
        of_plot.series.push_back({name_of(series, language), series.color, series.point, series.knob.has_value()});
    }
    return of_plot;
}

}  // namespace

std::string chart_script(const std::vector<SceneChart>& scenes, std::size_t cost, std::size_t error,
                         const PlotLayout& layout, Language language) {
    auto ordered = scenes;
    std::stable_partition(ordered.begin(), ordered.end(), [](const auto& scene) { return !scene.degenerate(); });
    std::vector<Plot> plots;
    for (const auto& scene : ordered) plots.push_back(plot_of(scene, cost, error, language));
    return plot_script(plots, plot_words(cost, error, language), layout);
}

}  // namespace vidno
