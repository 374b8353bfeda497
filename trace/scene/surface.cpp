/// Reading checks in this order: the text as JSON, the keys and types, the values, and last whether each curve has its samples
/// on the window's columns. The first fault ends it.
#include "scene/surface.h"

#include <cmath>
#include <numeric>

#include "json/json_node.h"
#include "json/json_text.h"
#include "scene/sampling.h"

namespace vidno {
namespace {

constexpr std::string_view surface_format = "vidno-surface/1";
constexpr int most_curves = 4096;
constexpr std::size_t most_samples = std::size_t{1} << 20;

std::string written(double number) {
    Text text;
    append_number(text, number);
    return text.string();
}

void expect_few_samples(const JsonNode& curves, std::size_t count) {
    if (count > most_samples) curves.refuse("together more than " + std::to_string(most_samples) + " samples");
}

double finite(const JsonNode& node) {
    const double number = node.number();
    if (!std::isfinite(number)) node.refuse("not finite");
    return number;
}

double positive(const JsonNode& node) {
    const double number = finite(node);
    if (!(number > 0)) node.refuse("not above 0");
    return number;
}

ScreenWay read_way(const JsonNode& node, int fewest_columns, int most_columns) {
    if (node.size() != 2) node.refuse("not columns and rows");
    return {node.at(0u).whole_number(fewest_columns, most_columns), finite(node.at(1u))};
}

SurfaceView read_view(const JsonNode& node) {
    node.require_keys({"origin", "across", "back", "up"});
    return {read_way(node.at("origin"), -farthest_offset, farthest_offset),
            read_way(node.at("across"), 1, largest_side), read_way(node.at("back"), -largest_side, largest_side),
            positive(node.at("up"))};
}

HeightFunction read_expression(const JsonNode& node) {
    try {
        return height_function(node.text());
    } catch (const Refused& refused) {
        node.refuse(printable(refused.what()));
    }
}

std::pair<double, double> read_range(const JsonNode& node) {
    if (node.size() != 2) node.refuse("not two numbers");
    const std::pair range(finite(node.at(0u)), finite(node.at(1u)));
    if (range.first == range.second) node.refuse("twice the same number");
    return range;
}

/// Says of curves that leave the window which one does.
void expect_in_window(const JsonNode& view, const SurfaceView& seen, int curves, const Area& area) {
    for (int i = 0; i < curves; ++i) {
        const int first = seen.origin.columns + seen.back.columns * i;
        const int last = first + seen.across.columns;
        if (first < area.x || last >= area.right()) {
            view.refuse("curve " + std::to_string(i) + " is over the columns " + std::to_string(first) + " to " +
                        std::to_string(last) + ", and the window has " + std::to_string(area.x) + " to " +
                        std::to_string(area.right() - 1));
        }
    }
}

FunctionSurface read_function_surface(const JsonNode& root, const Area& area) {
    FunctionSurface surface;
    surface.function = read_expression(root.at("function"));
    std::tie(surface.left, surface.right) = read_range(root.at("x"));
    std::tie(surface.nearest, surface.farthest) = read_range(root.at("z"));
    surface.curves = root.at("curves").whole_number(2, most_curves);
    surface.view = read_view(root.at("view"));
    surface.samples = root.at("samples").whole_number(2, surface.view.across.columns + 1);
    if (root.has("tolerance")) surface.tolerance = positive(root.at("tolerance"));
    expect_in_window(root.at("view"), surface.view, surface.curves, area);
    return surface;
}

/// The surface is that of the root. Refuses too many samples, and a function that is not finite at one.
std::vector<Curve> samples_of(const FunctionSurface& surface, const JsonNode& root) {
    const int most = surface.tolerance ? surface.view.across.columns + 1 : surface.samples;
    expect_few_samples(root.at("curves"), std::size_t(surface.curves) * std::size_t(most));
    try {
        return sampled(surface);
    } catch (const NotFinite& at) {
        root.at("function").refuse("not finite at x = " + written(at.x) + ", z = " + written(at.z));
    }
}

Curve read_curve(const JsonNode& node, const Area& area) {
    Curve curve;
    if (node.size() < 2) node.refuse("fewer than two samples");
    for (std::size_t i = 0; i < node.size(); ++i) {
        const JsonNode sample = node.at(i);
        if (sample.size() != 2) sample.refuse("not a column and a height");
        const int x = sample.at(0u).whole_number(area.x, area.right() - 1);
        if (i > 0 && x <= curve.samples.back().x) sample.at(0u).refuse("not right of the sample before");
        curve.samples.push_back({x, finite(sample.at(1u))});
    }
    return curve;
}

std::vector<Curve> read_curves(const JsonNode& node, const Area& area) {
    if (node.size() > std::size_t(most_curves)) node.refuse("more than " + std::to_string(most_curves) + " curves");
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < node.size(); ++i) curves.push_back(read_curve(node.at(i), area));
    return curves;
}

/// The keys that there must be, and the format.
void expect_surface(const JsonNode& root, bool is_function) {
    if (is_function) {
        root.require_keys({"format", "window", "function", "x", "z", "curves", "samples", "view"},
                          {"name", "tolerance"});
    } else {
        root.require_keys({"format", "window", "curves"}, {"name"});
    }
    if (root.at("format").text() != surface_format) root.at("format").refuse("not \"vidno-surface/1\"");
}

Surface read(const JsonNode& root) {
    const bool is_function = root.has("function");
    expect_surface(root, is_function);
    Surface surface;
    if (root.has("name")) surface.name = root.at("name").text();
    surface.curves.area = root.at("window").window();
    const Area& area = surface.curves.area;
    surface.curves.curves =
        is_function ? samples_of(read_function_surface(root, area), root) : read_curves(root.at("curves"), area);
    expect_few_samples(root.at("curves"), sample_count(surface.curves));
    return surface;
}

}  // namespace

std::size_t sample_count(const CurveScene& curves) {
    return std::accumulate(curves.curves.begin(), curves.curves.end(), std::size_t{0},
                           [](std::size_t count, const Curve& curve) { return count + curve.samples.size(); });
}

std::size_t column_count(const CurveScene& curves) {
    std::size_t count = 0;
    for (const auto& [samples] : curves.curves) count += std::size_t(samples.back().x - samples.front().x) + 1;
    return count;
}

bool is_surface(std::string_view text) { return document_format(text) == surface_format; }

Surface read_surface(std::string_view text, const std::string& file) { return read_json(text, file, read); }
Surface read_surface(const JsonNode& node) { return read(node); }

Function read_function(std::string_view text, const std::string& file) {
    return read_json(text, file, [](const JsonNode& root) {
        if (!root.has("function")) root.refuse("no function, which could be sampled in other ways");
        expect_surface(root, true);
        Function function;
        if (root.has("name")) function.name = root.at("name").text();
        function.area = root.at("window").window();
        function.surface = read_function_surface(root, function.area);
        function.file = root.object().dump();
        samples_of(on_each_column(function.surface), root);
        return function;
    });
}

std::string surface_json(const Surface& surface) {
    const auto& [area, curves] = surface.curves;
    Text out;
    out += "{\"format\":\"";
    out += surface_format;
    out += "\",\"name\":";
    append_string(out, surface.name);
    out += ",\"window\":";
    append_area(out, area);
    out += ",\"curves\":[";
    for (std::size_t i = 0; i < curves.size(); ++i) {
        out += i > 0 ? ",[" : "[";
        const auto& samples = curves[i].samples;
        for (std::size_t j = 0; j < samples.size(); ++j) {
            out += j > 0 ? ",[" : "[";
            append_integer(out, samples[j].x);
            out += ',';
            append_number(out, samples[j].y);
            out += ']';
        }
        out += ']';
    }
    out += "]}";
    return out.string();
}

}  // namespace vidno
