#include "chart.h"

#include "commands.h"
#include "output.h"
#include "page.h"
#include "program.h"
#include "progress.h"

namespace vidno::cli {

namespace {

using Format = std::string (*)(const std::vector<SceneChart>&, const ChartOptions&);

std::string as_json(const std::vector<SceneChart>& scenes, const ChartOptions&) { return chart_json(scenes); }
std::string as_csv(const std::vector<SceneChart>& scenes, const ChartOptions&) { return chart_csv(scenes); }
std::string as_page(const std::vector<SceneChart>& scenes, const ChartOptions&) {
    std::vector<SceneChart> known;
    for (const auto& scene : scenes) known.push_back(for_page(scene));
    return chart_page(chart_json(known));
}
std::string as_figure(const std::vector<SceneChart>& scenes, const ChartOptions& options) {
    return output_of({"gnuplot"}, chart_script(scenes, place_in(names_of(cost_axes), options.cost),
                                               place_in(names_of(error_axes), options.error)));
}

/// Refuses a wrong name, and what would be missing in the end, before the work.
Format format_of(const std::string& output) {
    if (output == "-" || output.ends_with(".json")) return as_json;
    if (output.ends_with(".csv")) return as_csv;
    if (output.ends_with(".svg")) {
        output_of({"gnuplot", "--version"}, "");
        return as_figure;
    }
    if (output.ends_with(".html")) {
        chart_page("null");
        return as_page;
    }
    throw Refused(output + ": not .json, .csv, .svg or .html");
}

}  // namespace

int chart(const ChartOptions& options) {
    const Format format = format_of(options.output);
    std::vector<Scene> scenes;
    std::size_t turns = 0;
    for (const auto& file : options.scenes) {
        scenes.push_back(scene_from(file));
        if (std::max(scenes.back().area.width, scenes.back().area.height) > largest_charted_side) {
            throw Refused(file + ": a chart takes areas of at most " + std::to_string(largest_charted_side) +
                          " pixels a side");
        }
        turns += turns_of(scenes.back());
    }
    OutputFile file(options.output);
    Progress progress("runs");
    std::vector<SceneChart> charts;
    std::size_t done = 0;
    for (const auto& scene : scenes) charts.push_back(chart_of(scene, [&] { progress.show(++done, turns); }));
    progress.clear();
    file.write(format(charts, options));
    file.commit();
    return 0;
}

}  // namespace vidno::cli
