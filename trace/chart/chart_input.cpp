// Reading a chart, as chart_json writes it.

#include <limits>

#include "chart/chart_input.h"
#include "choice/read_choice.h"
#include "json/json_node.h"

namespace vidno {

namespace {

std::uint64_t count_of(const JsonNode& node) {
    const double number = node.number();
    if (!(number >= 0 && number < 0x1p53)) node.refuse("not a count");
    return std::uint64_t(number);
}

double number_or_infinite(const JsonNode& node) {
    if (!node.is_text()) return node.number();
    if (node.text() != "inf") node.refuse("not a number");
    return std::numeric_limits<double>::infinity();
}

/// The items of a list, each read by `read`.
auto all_of(const JsonNode& list, const auto& read) {
    std::vector<decltype(read(list))> items;
    for (std::size_t i = 0; i < list.size(); ++i) items.push_back(read(list.at(i)));
    return items;
}

/// Marks the fronts that a run is on.
void read_fronts(const JsonNode& front, auto& run, const auto& cost_axes, const auto& error_axes) {
    front.require_keys({cost_axes[0].name, cost_axes[1].name, cost_axes[2].name});
    for (std::size_t cost = 0; cost < cost_axes.size(); ++cost) {
        const JsonNode errors = front.at(cost_axes[cost].name);
        for (std::size_t i = 0; i < errors.size(); ++i) {
            for (std::size_t error = 0; error < error_axes.size(); ++error) {
                if (errors.at(i).text() == error_axes[error].name) run.on_front[cost][error] = true;
            }
        }
    }
}

ChartRun run_of(const JsonNode& node) {
    node.require_keys(
        {"method", "kernel", "edition", "window", "knob", "value", "complete", "seconds", "time", "operations", "bits",
         "counts", "wrongPixels", "area", "decisions", "wrongDecisions", "depthUlps", "front"},
        {"picture"});
    ChartRun run{{Method(node.at("method").place_among(method_names)), read_kernel(node.at("kernel"))}, {}, {}};
    run.way.edition = read_edition(node.at("edition"));
    run.way.smallest_window = node.at("window").whole_number(1, largest_side);
    if (!node.at("knob").is_null()) {
        run.way.knob = Knob(node.at("knob").place_among(knob_names));
        run.way.value = node.at("value").whole_number(0, largest_side);
    }
    run.cost = {node.at("seconds").number(), node.at("time").number(), node.at("operations").number()};
    if (!node.at("bits").is_null()) run.cost.bits = node.at("bits").number();
    run.found.complete = node.at("complete").truth();
    run.found.wrong_pixels = count_of(node.at("wrongPixels"));
    run.found.area = node.at("area").number();
    run.found.decisions = count_of(node.at("decisions"));
    run.found.wrong_decisions = count_of(node.at("wrongDecisions"));
    run.found.depth_ulps = number_or_infinite(node.at("depthUlps"));
    read_fronts(node.at("front"), run, cost_axes, error_axes);
    return run;
}

SurfaceChartRun surface_chart_run_of(const JsonNode& node) {
    node.require_keys({"method", "kernel", "edition", "knob", "value", "seconds", "time", "operations", "samples",
                       "counts", "wrongColumns", "height", "decisions", "wrongDecisions", "front"},
                      {"picture"});
    SurfaceChartRun run{{read_kernel(node.at("kernel"))}, {}, {}};
    run.way.edition = read_edition(node.at("edition"));
    if (!node.at("knob").is_null()) {
        run.way.knob = SamplingKnob(node.at("knob").place_among(sampling_knob_names));
        run.way.value = node.at("value").number();
    }
    run.cost = {node.at("seconds").number(), node.at("time").number(), node.at("operations").number(),
                node.at("samples").number()};
    run.found.wrong_columns = count_of(node.at("wrongColumns"));
    run.found.height = node.at("height").number();
    run.found.decisions = count_of(node.at("decisions"));
    run.found.wrong_decisions = count_of(node.at("wrongDecisions"));
    read_fronts(node.at("front"), run, surface_cost_axes, surface_error_axes);
    return run;
}

SceneChart scene_of(const JsonNode& node) {
    node.require_keys({"name", "kind", "unsteady", "pixels", "polygons", "area", "runs"}, {"scene", "pictures"});
    SceneChart scene{.name = node.at("name").text(),
                     .unsteady = count_of(node.at("unsteady")),
                     .pixels = count_of(node.at("pixels")),
                     .polygons = count_of(node.at("polygons")),
                     .area = node.at("area").number()};
    scene.runs = all_of(node.at("runs"), run_of);
    return scene;
}

SurfaceChart surface_of(const JsonNode& node) {
    node.require_keys({"name", "curves", "columns", "runs"}, {"surface", "pictures"});
    return {node.at("name").text(), count_of(node.at("curves")), count_of(node.at("columns")),
            all_of(node.at("runs"), surface_chart_run_of)};
}

}  // namespace

AnyChart read_chart(std::string_view text, const std::string& file) {
    return read_json(text, file, [](const JsonNode& node) -> AnyChart {
        node.object();
        node.expect_format(chart_format);
        const bool of_surfaces = node.has("surfaces");
        const std::string_view subjects = of_surfaces ? "surfaces" : "scenes";
        node.require_keys({"format", "rounds", subjects});
        if (node.at(subjects).size() == 0) node.at(subjects).refuse("none");
        if (of_surfaces) return all_of(node.at(subjects), surface_of);
        return all_of(node.at(subjects), scene_of);
    });
}

}  // namespace vidno
