// Which runs of a chart its figure shows, and in which words.

#include <algorithm>
#include <functional>
#include <limits>

#include "chart_figure.h"
#include "choice/method.h"
#include "say/numbers.h"
#include "say/words.h"
#include "scene/scene_names.h"

namespace vidno::figures {

namespace {

struct AxisWords {
    std::string_view name;  // as in files
    Bilingual words;
};

constexpr std::array axis_words{
    AxisWords{"time", {"time, times that of the fastest", "время относительно самого быстрого"}},
    AxisWords{"operations", {"operations, times the fewest", "операции относительно наименьшего числа"}},
    AxisWords{"bits", {"operations × bits, times the fewest", "операции × биты относительно наименьшего числа"}},
    AxisWords{"samples", {"samples, times the fewest", "отсчёты относительно наименьшего числа"}},
    AxisWords{"wrongPixels", {"wrong pixels, %", "неверные пиксели, %"}},
    AxisWords{"wrongColumns", {"wrong columns, %", "неверные столбцы, %"}},
    AxisWords{"area", {"area that differs, %", "площадь расхождения, %"}},
    AxisWords{"height", {"height missed, pixels", "потерянная высота, пиксели"}},
    AxisWords{"wrongDecisions", {"wrong decisions, %", "неверные решения, %"}},
    AxisWords{"depthUlps", {"depth error, ulps", "ошибка глубины, ulp"}},
};

std::string words_of_axis(const auto& axis, Language language) {
    return std::string(std::ranges::find(axis_words, axis.name, &AxisWords::name)->words.in(language));
}

struct PanelWords {
    std::string_view warnock;  // also before the name of a variant
    std::string_view ordinary, degenerate, as_given, samples, tolerance;
};

const InEachLanguage<PanelWords> panel_words{{.warnock = "Warnock",
                                              .ordinary = "ordinary",
                                              .degenerate = "degenerate",
                                              .as_given = "as given",
                                              .samples = "{} samples",
                                              .tolerance = "tolerance {} px"},
                                             {.warnock = "Варнок",
                                              .ordinary = "обычная",
                                              .degenerate = "вырожденная",
                                              .as_given = "как задано",
                                              .samples = "отсчётов: {}",
                                              .tolerance = "допуск {} px"}};

std::string charted_name(Method method, Language language) {
    const std::string title(choice_of(method).title.in(language)), warnock(panel_words.in(language).warnock);
    return method == Method::warnock ? warnock : is_family(method) ? warnock + ", " + title : title;
}

/// Beyond these powers the arithmetic of the scales would overflow. Zero and infinity have places of their own.
double within_scale(double value) {
    const bool is_number = value > 0 && value < std::numeric_limits<double>::infinity();
    return is_number ? std::clamp(value, 1e-250, 1e250) : value;
}

/// An error as the figure shows it: a distance as it is, a share of all decisions or of the whole picture in per cent.
double shown_error(std::string_view axis, double value, std::size_t whole) {
    if (axis == "depthUlps" || axis == "height") return within_scale(value);
    return within_scale(axis == "wrongDecisions" ? 100 * value : 100 * value / double(whole));
}

bool is_compared(const NamedKernel& kernel) {
    constexpr std::array<std::string_view, 4> compared{"float", "double", "filtered", "exact"};
    return std::ranges::find(compared, kernel.choice->name) != compared.end();
}

/// The runs that a figure may show. A run that a fault ended has no picture, and the printed text has defects.
template <class Run>
std::vector<const Run*> runs_to_show(const std::vector<Run>& runs, const CostAxis<Run>& cost) {
    std::vector<const Run*> found;
    for (const Run& run : runs) {
        const bool is_shown = run.is_complete() && run.way.edition == Edition::corrected && is_compared(run.way.kernel);
        if (is_shown && cost.of(run).value_or(0) > 0) found.push_back(&run);
    }
    return found;
}

/// The cheapest run without an error, null if there is none. At the same cost, one that is right for every scene comes
/// first.
template <class Run>
const Run* cheapest_right(const std::vector<const Run*>& runs, const CostAxis<Run>& cost, const ErrorAxis<Run>& error) {
    const auto place = [&](const Run* run) { return std::pair(*cost.of(*run), !run->way.kernel.is_always_right()); };
    const Run* best = nullptr;
    for (const Run* run : runs) {
        if (error.of(*run) == 0 && (!best || place(run) < place(best))) best = run;
    }
    return best;
}

/// Those of the runs that have the property.
template <class Run>
std::vector<const Run*> with_property(const std::vector<const Run*>& runs, const auto& property) {
    std::vector<const Run*> found;
    std::ranges::copy_if(runs, std::back_inserter(found), property);
    return found;
}

void add_if_any(auto& runs, const auto* run) {
    if (run) runs.push_back(run);
}

/// Their marks.
template <class Run>
std::vector<ChartMark> marks_of(const std::vector<const Run*>& chosen, const CostAxis<Run>& cost,
                                const ErrorAxis<Run>& wrong, const auto& mark_of) {
    double least = std::numeric_limits<double>::infinity();
    for (const Run* run : chosen) least = std::min(least, *cost.of(*run));
    const Run* const cheapest = cheapest_right(chosen, cost, wrong);
    std::vector<ChartMark> marks;
    for (const Run* run : chosen) {
        ChartMark mark = mark_of(*run);
        mark.cost = std::min(within_scale(*cost.of(*run) / least), 1e250);
        mark.kernel = run->way.kernel.choice->name;
        mark.is_cheapest = run == cheapest;
        marks.push_back(std::move(mark));
    }
    return marks;
}

}  // namespace

ChartPanel panel_of(const SceneChart& scene, std::size_t cost, std::size_t error, Language language) {
    const PanelWords& words = panel_words.in(language);
    const auto& cost_axis = cost_axes[cost];
    const auto& error_axis = error_axes[error];
    const auto is_of_lecture = [](const ChartRun* run) { return is_of_course(run->way.method) && !run->way.knob; };
    const auto is_other = [](const ChartRun* run) { return !is_of_course(run->way.method) && !run->way.knob; };
    const auto runs = runs_to_show(scene.runs, cost_axis);
    auto chosen = with_property(runs, is_of_lecture);
    add_if_any(chosen, cheapest_right(with_property(runs, is_other), cost_axis, error_axes.front()));

    const auto mark_of = [&](const ChartRun& run) {
        using enum ChartMark::Shape;
        const Method method = run.way.method;
        return ChartMark{.error = shown_error(error_axis.name, error_axis.of(run), scene.pixels),
                         .way = charted_name(method, language),
                         .kernel = {},
                         .shape = method == Method::zbuffer   ? circle
                                  : method == Method::warnock ? square
                                                              : triangle};
    };
    return {.title = name_in(language, scene.name) + " (" +
                     std::string(scene.degenerate() ? words.degenerate : words.ordinary) + ")",
            .cost = words_of_axis(cost_axis, language),
            .error = words_of_axis(error_axis, language),
            .least = error_axis.name == "area" ? shown_error(error_axis.name, scene.area, scene.pixels) : 0,
            .marks = marks_of(chosen, cost_axis, error_axes.front(), mark_of)};
}

ChartPanel panel_of(const SurfaceChart& surface, std::size_t cost, std::size_t error, Language language) {
    const PanelWords& words = panel_words.in(language);
    const auto& cost_axis = surface_cost_axes[cost];
    const auto& error_axis = surface_error_axes[error];
    const auto runs = runs_to_show(surface.runs, cost_axis);
    const auto by = [&](std::optional<SamplingKnob> knob) {
        return with_property(runs, [&](const SurfaceChartRun* run) { return run->way.knob == knob; });
    };
    const auto sampled = by(SamplingKnob::samples);
    double most = 0;
    for (const auto* run : sampled) most = std::max(most, run->way.value);
    const auto is_dense = [&](const SurfaceChartRun* run) { return run->way.value == most; };
    auto chosen = by(std::nullopt);
    std::ranges::copy(with_property(sampled, is_dense), std::back_inserter(chosen));
    add_if_any(chosen,
               cheapest_right(with_property(sampled, std::not_fn(is_dense)), cost_axis, surface_error_axes.front()));
    add_if_any(chosen, cheapest_right(by(SamplingKnob::tolerance), cost_axis, surface_error_axes.front()));

    const auto mark_of = [&](const SurfaceChartRun& run) {
        using enum ChartMark::Shape;
        const auto knob = run.way.knob;
        const auto pattern = !knob ? words.as_given : knob == SamplingKnob::samples ? words.samples : words.tolerance;
        return ChartMark{.error = shown_error(error_axis.name, error_axis.of(run), surface.columns),
                         .way = say::filled(pattern, {say::in_format(decimal(run.way.value), language)}),
                         .kernel = {},
                         .shape = !knob                           ? circle
                                  : knob == SamplingKnob::samples ? square
                                                                  : triangle};
    };
    return {.title = name_in(language, surface.name),
            .cost = words_of_axis(cost_axis, language),
            .error = words_of_axis(error_axis, language),
            .least = 0,
            .marks = marks_of(chosen, cost_axis, surface_error_axes.front(), mark_of)};
}

}  // namespace vidno::figures
