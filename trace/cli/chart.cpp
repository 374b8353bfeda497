#include "chart/chart.h"

#include "chart/chart_input.h"
#include "cli/commands.h"
#include "cli/shared/chart_axes.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/scene_files.h"
#include "figure/encoded.h"
#include "output.h"
#include "page/page.h"

namespace vidno::cli {

namespace {

struct ChartOptions {
    std::vector<std::string> scenes;
    std::string output;
    AxisOptions axes;  // of the figure
};

bool is_figure(const std::string& output) {
    constexpr std::array<std::string_view, 3> extensions{".svg", ".pdf", ".png"};
    return std::ranges::any_of(extensions, [&](std::string_view each) { return output.ends_with(each); });
}

/// Refuses a wrong name, and an output that could not be written, before the work.
void expect_format(const ChartOptions& options, bool of_surfaces) {
    const std::string& output = options.output;
    if (output == "-" || output.ends_with(".json") || output.ends_with(".csv")) return;
    if (is_figure(output)) {
        expect_axes(options.axes, of_surfaces);
    } else if (!output.ends_with(".html")) {
        throw Refused(output + ": not .json, .csv, .svg, .pdf, .png or .html");
    } else {
        chart_page("null");
    }
}

std::string written(const auto& charts, const ChartOptions& options) {
    if (options.output.ends_with(".html")) return chart_page(chart_json(charts));
    if (options.output.ends_with(".csv")) return chart_csv(charts);
    if (!is_figure(options.output)) return chart_json(charts);
    const auto panels = panels_of(charts, options.axes, Language::english);
    return figures::encoded(figures::chart_figure(panels, {}, usual_width_of(panels)), {panels.front().title},
                            options.output);
}

void expect_size(const Scene& scene, const std::string& file) {
    if (std::max(scene.area.width, scene.area.height) <= largest_charted_side) return;
    throw Refused(file + ": a chart needs an area of at most " + std::to_string(largest_charted_side) +
                  " pixels a side");
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

/// The first loss of each run that lost something.
void add_losses(const std::vector<SceneChart>& charts, const std::vector<std::string>& files, Losses& losses) {
    for (std::size_t i = 0; i < charts.size(); ++i) {
        std::vector<Loss> of_runs;
        for (const ChartRun& charted : charts[i].runs) {
            if (charted.found.losses.empty()) continue;
            const Way& way = charted.way;
            const auto& [what, where] = charted.found.losses.front();
            const std::string run = std::string(method_names[std::size_t(way.method)]) + " under " + way.kernel.name() +
                                    ", " + name_of(way.edition);
            of_runs.push_back({what, run + ", " + where});
        }
        losses.add(files[i], of_runs);
    }
}
/// No text of the floating horizon has a fault.
void add_losses(const std::vector<SurfaceChart>&, const std::vector<std::string>&, Losses&) {}

int chart(const ChartOptions& options) {
    std::vector<AdmittedScene> scenes;
    std::vector<Function> functions;
    for (const auto& file : options.scenes) {
        auto read = charted_scene_from(file);
        if (auto* scene = std::get_if<AdmittedScene>(&read)) {
            expect_size(*scenes.emplace_back(std::move(*scene)), file);
        } else {
            expect_size(functions.emplace_back(std::move(std::get<Function>(read))), file);
        }
        if (!scenes.empty() && !functions.empty()) throw Refused(file + ": a chart shows scenes or surfaces, not both");
    }
    expect_format(options, scenes.empty());
    OutputFile file(options.output);
    Losses losses;
    const auto chart_all = [&](const auto& subjects) {
        const auto charts = charts_of(subjects);
        add_losses(charts, options.scenes, losses);
        return written(charts, options);
    };
    file.write(scenes.empty() ? chart_all(functions) : chart_all(scenes));
    file.commit();
    return losses.report();
}

}  // namespace

void add_chart(CLI::App& program, int& status) {
    auto& command =
        *program.add_subcommand("chart", "Plot error against cost for every method, kernel, edition and setting");
    const auto options = std::make_shared<ChartOptions>();
    command
        .add_option("SCENE", options->scenes,
                    "Scene files, vidno-scene/1, or surface files, vidno-surface/1, with a function")
        ->required();
    add_axes(command, options->axes, "The horizontal axis of a figure [time]");
    command
        .add_option("-o", options->output, "The chart, .json, .csv, .html (a page), or a figure, .svg, .pdf or .png")
        ->required();
    command.footer(
        "The settings are the bits of arithmetic, of the Z-buffer and of the grid, and the smallest window; for "
        "surfaces\n"
        "the samples per curve and the tolerance. Times are medians of five interleaved runs, relative to the "
        "fastest;\n"
        "counts of operations are always the same.\n"
        "The page and the figure show what a right picture costs. The page adds any series by choice, and shows each\n"
        "run's picture beside the exact one.\n"
        "Exit status 1: a run lost something; standard error says which run, what and where.\n"
        "Examples: vidno chart lessons/charts/*.json -o chart.html\n"
        "          vidno chart lessons/surfaces/*.json -o surfaces.html");
    command.callback([options, &status] { status = chart(*options); });
}

}  // namespace vidno::cli
