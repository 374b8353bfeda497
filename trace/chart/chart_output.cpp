#include <cmath>
#include <nlohmann/json.hpp>

#include "chart/chart.h"
#include "chart/surface_chart.h"
#include "format/floating_horizon_trace.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

Json number_or_infinite(double value) { return std::isfinite(value) ? Json(value) : Json("inf"); }

Json counts_of(const auto& operations, const auto& names) {
    Json counts = Json::object();
    for (std::size_t i = 0; i < operations.size(); ++i) counts[std::string(names[i])] = operations[i];
    return counts;
}

Json fronts_of(const auto& run, const auto& cost_axes, const auto& error_axes) {
    Json fronts = Json::object();
    for (std::size_t cost = 0; cost < cost_axes.size(); ++cost) {
        Json& errors = fronts[std::string(cost_axes[cost].name)] = Json::array();
        for (std::size_t error = 0; error < error_axes.size(); ++error) {
            if (run.on_front[cost][error]) errors.push_back(error_axes[error].name);
        }
    }
    return fronts;
}

Json json_of(const ChartRun& run) {
    const auto& way = run.way;
    const auto& cost = run.cost;
    const auto& found = run.found;
    return {{"method", method_names[std::size_t(way.method)]},
            {"kernel", way.kernel.name()},
            {"edition", name_of(way.edition)},
            {"window", way.smallest_window},
            {"knob", way.knob ? Json(knob_names[std::size_t(*way.knob)]) : Json()},
            {"value", way.knob ? Json(way.value) : Json()},
            {"complete", found.complete},
            {"seconds", cost.seconds},
            {"time", cost.time},
            {"operations", std::uint64_t(cost.operations)},
            {"bits", cost.bits ? Json(std::uint64_t(*cost.bits)) : Json()},
            {"counts", counts_of(found.operations, operation_names)},
            {"wrongPixels", found.wrong_pixels},
            {"area", found.area},
            {"decisions", found.decisions},
            {"wrongDecisions", found.wrong_decisions},
            {"depthUlps", number_or_infinite(found.depth_ulps)},
            {"front", fronts_of(run, cost_axes, error_axes)}};
}

Json json_of(const SurfaceChartRun& run) {
    const auto& way = run.way;
    const auto& cost = run.cost;
    const auto& found = run.found;
    return {{"method", floating_horizon_method},
            {"kernel", way.kernel.name()},
            {"edition", name_of(way.edition)},
            {"knob", way.knob ? Json(sampling_knob_names[std::size_t(*way.knob)]) : Json()},
            {"value", way.knob ? Json(way.value) : Json()},
            {"seconds", cost.seconds},
            {"time", cost.time},
            {"operations", std::uint64_t(cost.operations)},
            {"samples", std::uint64_t(cost.samples)},
            {"counts", counts_of(found.operations, floating_horizon_operation_names)},
            {"wrongColumns", found.wrong_columns},
            {"height", found.height},
            {"decisions", found.decisions},
            {"wrongDecisions", found.wrong_decisions},
            {"front", fronts_of(run, surface_cost_axes, surface_error_axes)}};
}

Json head_of(const SceneChart& scene) {
    return {{"name", scene.name},         {"kind", scene.degenerate() ? "degenerate" : "ordinary"},
            {"unsteady", scene.unsteady}, {"pixels", scene.pixels},
            {"polygons", scene.polygons}, {"area", scene.area}};
}

Json head_of(const SurfaceChart& surface) {
    return {{"name", surface.name}, {"curves", surface.curves}, {"columns", surface.columns}};
}

/// A list in brackets, with each item on its own line.
std::string listed(const auto& items, const auto& text_of) {
    std::string text;
    for (const auto& item : items) text += (text.empty() ? "\n" : ",\n") + text_of(item);
    return "[" + text + "]";
}

/// An object as text, with one more key at its end whose value is already text.
std::string with(std::string object, const std::string& key, const std::string& value) {
    object.back() = ',';
    return object + Json(key).dump() + ":" + value + "}";
}

// ------------------------------------------------------------------------------------- CSV, RFC 4180

std::string in_quotes(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string cell_of(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_string()) return in_quotes(value.get<std::string>());
    if (!value.is_array()) return value.dump();
    std::string words;
    for (const auto& word : value) words += (words.empty() ? "" : " ") + word.get<std::string>();
    return in_quotes(words);
}

/// A run as flat columns: an object's members are named `key.inner`.
std::vector<std::pair<std::string, std::string>> cells_of(const Json& object, const std::string& prefix = {}) {
    std::vector<std::pair<std::string, std::string>> cells;
    for (const auto& [key, value] : object.items()) {
        if (value.is_object()) {
            for (auto& inner : cells_of(value, prefix + key + ".")) cells.push_back(std::move(inner));
        } else {
            cells.emplace_back(prefix + key, cell_of(value));
        }
    }
    return cells;
}

/// A chart of such subjects, each as text.
std::string file_of(const std::string& subjects, const auto& charts, const auto& text_of) {
    const Json head{{"format", chart_format}, {"rounds", chart_rounds}};
    return with(head.dump(), subjects, listed(charts, text_of)) + "\n";
}

/// The pictures are only in the JSON: a row of CSV is one run.
std::string runs_of(const auto& chart) {
    return listed(chart.runs, [](const auto& run) {
        Json object = json_of(run);
        object["picture"] = run.picture;
        return object.dump();
    });
}

std::string rows_of(const std::string& subject, const auto& charts) {
    std::string text;
    for (const auto& chart : charts) {
        for (const auto& run : chart.runs) {
            Json row;
            row[subject] = head_of(chart);
            row.update(json_of(run));
            std::string names, values;
            for (const auto& [name, value] : cells_of(row)) {
                names += (names.empty() ? "" : ",") + name;
                values += (values.empty() ? "" : ",") + value;
            }
            if (text.empty()) text = names + "\r\n";
            text += values + "\r\n";
        }
    }
    return text;
}

}  // namespace

std::string chart_json(const std::vector<SceneChart>& scenes) {
    return file_of("scenes", scenes, [](const SceneChart& scene) {
        const std::string head = with(with(head_of(scene).dump(), "scene", scene.scene), "pictures", scene.pictures);
        return with(head, "runs", runs_of(scene));
    });
}
std::string chart_json(const std::vector<SurfaceChart>& surfaces) {
    return file_of("surfaces", surfaces, [](const SurfaceChart& surface) {
        const std::string head =
            with(with(head_of(surface).dump(), "surface", surface.surface), "pictures", surface.pictures);
        return with(head, "runs", runs_of(surface));
    });
}

std::string chart_csv(const std::vector<SceneChart>& scenes) { return rows_of("scene", scenes); }
std::string chart_csv(const std::vector<SurfaceChart>& surfaces) { return rows_of("surface", surfaces); }

}  // namespace vidno
