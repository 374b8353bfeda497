#include "chart/chart.h"

#include "chart/chart_input.h"
#include "commands.h"
#include "output.h"
#include "page/page.h"
#include "page/program.h"
#include "progress.h"

namespace vidno::cli {

namespace {

/// The place of an axis; the first one if none is named.
std::size_t place_of(const std::string& option, const std::optional<std::string>& name, const auto& axes) {
    if (!name) return 0;
    const auto names = names_of(axes);
    const std::size_t place = place_in(names, *name);
    if (place < names.size()) return place;
    std::string there;
    for (const auto& each : names) there += (there.empty() ? "" : ", ") + each;
    throw Refused(option + " " + *name + ": this chart has " + there);
}

/// Of the cost and of the error.
std::pair<std::size_t, std::size_t> places_of(const AxisOptions& axes, const auto& costs, const auto& errors) {
    return {place_of("--cost", axes.cost, costs), place_of("--error", axes.error, errors)};
}

/// Refuses a wrong name, and what would be missing in the end, before the work.
void expect_format(const ChartOptions& options, bool of_surfaces) {
    const std::string& output = options.output;
    if (output == "-" || output.ends_with(".json") || output.ends_with(".csv")) return;
    if (output.ends_with(".svg")) {
        output_of({"gnuplot", "--version"}, "");
        if (of_surfaces) {
            places_of(options.axes, surface_cost_axes, surface_error_axes);
        } else {
            places_of(options.axes, cost_axes, error_axes);
        }
    } else if (!output.ends_with(".html")) {
        throw Refused(output + ": not .json, .csv, .svg or .html");
    } else {
        chart_page("null");
    }
}

std::string written(const auto& charts, const ChartOptions& options) {
    if (options.output.ends_with(".html")) return chart_page(chart_json(charts));
    if (options.output.ends_with(".csv")) return chart_csv(charts);
    if (!options.output.ends_with(".svg")) return chart_json(charts);
    return output_of({"gnuplot"}, script_of(charts, options.axes));
}

void expect_size(const Scene& scene, const std::string& file) {
    if (std::max(scene.area.width, scene.area.height) <= largest_charted_side) return;
    throw Refused(file + ": a chart takes areas of at most " + std::to_string(largest_charted_side) + " pixels a side");
}
void expect_size(const Function& function, const std::string& file) {
    const FunctionSurface& surface = function.surface;
    const auto columns = std::size_t(surface.curves) * std::size_t(surface.view.across.columns + 1);
    if (columns <= most_charted_columns) return;
    throw Refused(file + ": a chart takes curves of at most " + std::to_string(most_charted_columns) +
                  " columns together");
}

/// The charts of subjects of one kind.
auto charts_of(const auto& subjects) {
    std::size_t turns = 0, done = 0;
    for (const auto& subject : subjects) turns += turns_of(subject);
    Progress progress("runs");
    std::vector<decltype(chart_of(subjects[0], std::function<void()>()))> charts;
    for (const auto& subject : subjects) {
        charts.push_back(chart_of(subject, [&] { progress.show(++done, turns); }));
    }
    progress.clear();
    return charts;
}

int chart_all(const std::vector<std::string>& texts, const ChartOptions& options, const auto& read) {
    std::vector<decltype(read(texts[0], options.scenes[0]))> subjects;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        subjects.push_back(read(texts[i], options.scenes[i]));
        expect_size(subjects.back(), options.scenes[i]);
    }
    OutputFile file(options.output);
    file.write(written(charts_of(subjects), options));
    file.commit();
    return 0;
}

}  // namespace

std::string script_of(const std::vector<SceneChart>& scenes, const AxisOptions& axes, const PlotLayout& layout,
                      bool in_russian) {
    const auto [cost, error] = places_of(axes, cost_axes, error_axes);
    return chart_script(scenes, cost, error, layout, in_russian ? chart_in_russian : chart_in_english);
}

std::string script_of(const std::vector<SurfaceChart>& surfaces, const AxisOptions& axes, const PlotLayout& layout,
                      bool in_russian) {
    const auto [cost, error] = places_of(axes, surface_cost_axes, surface_error_axes);
    return chart_script(surfaces, cost, error, layout,
                        in_russian ? surface_chart_in_russian : surface_chart_in_english);
}

int chart(const ChartOptions& options) {
    std::vector<std::string> texts;
    for (const auto& file : options.scenes) {
        texts.push_back(read_file(file));
        if (is_surface(texts.back()) == is_surface(texts[0])) continue;
        throw Refused(file + ": a chart is of scenes or of surfaces, not of both");
    }
    const bool of_surfaces = is_surface(texts[0]);
    expect_format(options, of_surfaces);
    return of_surfaces ? chart_all(texts, options, read_function) : chart_all(texts, options, scene_of);
}

}  // namespace vidno::cli
