/// Reading checks in this order: the text as JSON, the keys and types, the values, and finally whether each curve has
/// its samples on the window's columns. An error in the text ends it; all other errors are reported together.
#include "scene/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "counted.h"
#include "json/document_format.h"
#include "json/json_node.h"
#include "json/json_text.h"
#include "scene/default_window.h"
#include "scene/sampling.h"

namespace vidno {
namespace {

constexpr std::string_view surface_format = "vidno-surface/1";
constexpr int most_curves = 4096;
constexpr std::size_t most_samples = std::size_t{1} << 20;

void expect_few_samples(const JsonNode& curves, std::size_t count) {
    if (count > most_samples) curves.refuse("together more than " + std::to_string(most_samples) + " samples");
}

double finite(const JsonNode& node) {
    const double number = node.number();
    if (!std::isfinite(number)) node.refuse("not finite");
    return number;
}

/// null: there is none.
double height(const JsonNode& node) { return node.is_null() ? std::numeric_limits<double>::quiet_NaN() : finite(node); }

double positive(const JsonNode& node) {
    const double number = finite(node);
    if (!(number > 0)) node.refuse("not greater than 0");
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
    const std::string& formula = node.text();
    try {
        return height_function(formula);
    } catch (const Refused& refused) {
        node.refuse(printable(refused.what()));
    }
}

std::pair<double, double> read_range(const JsonNode& node) {
    if (node.size() != 2) node.refuse("not two numbers");
    const std::pair range(finite(node.at(0u)), finite(node.at(1u)));
    if (range.first == range.second) node.refuse("the two numbers are equal");
    return range;
}

/// Names the curve that leaves the window.
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

bool has_point(const Curve& curve) {
    return std::any_of(curve.samples.begin(), curve.samples.end(), [](const Sample& each) { return each.has_point(); });
}

/// Refuses samples none of which has a point; a scene without samples is empty, and allowed.
void expect_some_point(const JsonNode& node, const std::vector<Curve>& curves, const char* reason) {
    if (!curves.empty() && std::none_of(curves.begin(), curves.end(), has_point)) node.refuse(reason);
}

/// The surface of the root. Refuses too many samples, and a function that is not finite at any of them.
std::vector<Curve> samples_of(const FunctionSurface& surface, const JsonNode& root) {
    const int most = surface.tolerance ? surface.view.across.columns + 1 : surface.samples;
    expect_few_samples(root.at("curves"), std::size_t(surface.curves) * std::size_t(most));
    std::vector<Curve> curves = sampled(surface);
    expect_some_point(root.at("function"), curves, "not finite at any sample");
    return curves;
}

/// The limits of the columns of any window.
constexpr Area any_columns{-farthest_offset, 0, 2 * (farthest_offset - 1), 1};

class SurfaceReader {
public:
    explicit SurfaceReader(const JsonNode& root, Defaults defaults = Defaults::taken)
        : root_(root), defaults_(defaults) {}

    Surface surface() {
        expect_keys();
        read_name_and_window();
        if (has_function()) {
            const FunctionSurface function = function_surface();
            faults_.settle();
            curves_.curves = samples_of(function, root_);
        } else {
            read_member("curves", [&](const JsonNode& node) { read_curves(node); });
            faults_.settle();
            expect_some_point(root_.at("curves"), curves_.curves, "no sample has a y");
        }
        expect_few_samples(root_.at("curves"), sample_count(curves_));
        take_default_window();
        return {std::move(name_), admit(std::move(curves_))};
    }

    /// Requires a surface given as a function.
    Function function() {
        root_.object();
        root_.expect_format(surface_format);
        if (!has_function()) root_.refuse("has no function that could be sampled in other ways");
        expect_keys();
        read_name_and_window();
        Function function;
        function.surface = function_surface();
        faults_.settle();
        curves_.curves = samples_of(on_each_column(function.surface), root_);
        take_default_window();
        function.name = name_;
        function.area = curves_.area;
        function.file = root_.object().dump();
        return function;
    }

private:
    bool has_function() const { return root_.has("function"); }

    void expect_keys() {
        root_.object();
        root_.expect_format(surface_format);
        faults_.attempt([&] {
            if (defaults_ == Defaults::none) {
                root_.require_keys({"format", "window", "curves"}, {"name"});
            } else if (has_function()) {
                root_.require_keys({"function", "x", "z", "curves", "samples", "view"},
                                   {"format", "name", "window", "tolerance"});
            } else {
                root_.require_keys({"curves"}, {"format", "name", "window"});
            }
        });
    }

    void read_name_and_window() {
        read_member("name", [&](const JsonNode& node) { name_ = node.text(); });
        Area& area = curves_.area;
        has_window_ = read_member("window", [&](const JsonNode& node) { area = node.window(); });
    }

    /// Reads a member if it is present. False if it is not, or was refused.
    bool read_member(std::string_view key, auto&& read) {
        return root_.has(key) && faults_.attempt([&] { read(root_.at(key)); });
    }

    /// Errors are added to the faults.
    FunctionSurface function_surface() {
        FunctionSurface surface;
        int most_samples_a_curve = largest_side + 1;
        read_member("function", [&](const JsonNode& node) { surface.function = read_expression(node); });
        read_member("x", [&](const JsonNode& node) { std::tie(surface.left, surface.right) = read_range(node); });
        read_member("z", [&](const JsonNode& node) { std::tie(surface.nearest, surface.farthest) = read_range(node); });
        const bool has_curves =
            read_member("curves", [&](const JsonNode& node) { surface.curves = node.whole_number(2, most_curves); });
        read_member("view", [&](const JsonNode& node) {
            surface.view = read_view(node);
            most_samples_a_curve = surface.view.across.columns + 1;
            if (has_curves && has_window_) expect_in_window(node, surface.view, surface.curves, curves_.area);
        });
        read_member("samples",
                    [&](const JsonNode& node) { surface.samples = node.whole_number(2, most_samples_a_curve); });
        read_member("tolerance", [&](const JsonNode& node) { surface.tolerance = positive(node); });
        return surface;
    }

    void read_curves(const JsonNode& node) {
        if (node.size() > std::size_t(most_curves)) node.refuse("more than " + std::to_string(most_curves) + " curves");
        for (std::size_t i = 0; i < node.size(); ++i) {
            faults_.attempt([&] { curves_.curves.push_back(read_curve(node.at(i))); });
        }
    }

    Curve read_curve(const JsonNode& node) {
        const Area& area = has_window_ ? curves_.area : any_columns;
        Curve curve;
        if (node.size() < 2) node.refuse("fewer than two samples");
        for (std::size_t i = 0; i < node.size(); ++i) {
            faults_.attempt([&] {
                const JsonNode sample = node.at(i);
                if (sample.size() != 2) sample.refuse("not a column and a y");
                const int x = sample.at(0u).whole_number(area.x, area.right() - 1);
                if (!curve.samples.empty() && x <= curve.samples.back().x) {
                    sample.at(0u).refuse("not right of the sample before");
                }
                curve.samples.push_back({x, height(sample.at(1u))});
            });
        }
        return curve;
    }

    void take_default_window() {
        if (has_window_) return;
        const auto window = default_window(curves_.curves);
        if (!window) {
            root_.refuse(curves_.curves.empty() ? "\"window\" is missing, and there are no samples to derive it from"
                                                : "\"window\" is missing, and the samples reach too far for one");
        }
        curves_.area = *window;
    }

    const JsonNode& root_;
    Defaults defaults_;
    Faults faults_;
    bool has_window_ = false;
    std::string name_;
    CurveScene curves_;
};

Surface read(const JsonNode& root) { return SurfaceReader(root).surface(); }

}  // namespace

std::string name_of(const AnyScene& scene) {
    const auto* surface = std::get_if<Surface>(&scene);
    return surface ? surface->name : std::get<AdmittedScene>(scene)->name;
}

std::size_t sample_count(const CurveScene& curves) {
    return std::accumulate(curves.curves.begin(), curves.curves.end(), std::size_t{0},
                           [](std::size_t count, const Curve& curve) { return count + curve.samples.size(); });
}

std::size_t column_count(const CurveScene& curves) {
    std::size_t count = 0;
    for (const Curve& curve : curves.curves) {
        for (const Piece& piece : pieces_of(curve)) count += std::size_t(piece.back().x - piece.front().x) + 1;
    }
    return count;
}

std::string gaps_in_words(const CurveScene& curves) {
    std::string first;
    std::size_t without_point = 0, in_pieces = 0;
    for (std::size_t i = 0; i < curves.curves.size(); ++i) {
        for (const Sample& sample : curves.curves[i].samples) {
            if (sample.has_point()) continue;
            if (first.empty()) first = "curve " + std::to_string(i) + ", column " + std::to_string(sample.x);
            ++without_point;
        }
        for (const Piece& piece : pieces_of(curves.curves[i])) in_pieces += piece.size();
    }
    if (without_point == 0) return {};
    const std::size_t all = sample_count(curves), alone = all - without_point - in_pieces;
    std::string words = "gaps: no finite height at " + std::to_string(without_point) + " of " + std::to_string(all) +
                        " samples, first at " + first;
    if (alone > 0) words += "; " + counted(alone, "sample between gaps is", "samples between gaps are") + " not drawn";
    return words;
}

bool is_surface(std::string_view text) { return are_of_one_kind(document_format(text), surface_format); }

Surface read_surface(std::string_view text, const std::string& file) { return read_json(text, file, read); }
Surface read_surface(const JsonNode& node) { return read(node); }
Surface read_whole_surface(const JsonNode& node) { return SurfaceReader(node, Defaults::none).surface(); }

Function read_function(std::string_view text, const std::string& file) {
    return read_json(text, file, [](const JsonNode& root) { return read_function(root); });
}
Function read_function(const JsonNode& node) { return SurfaceReader(node).function(); }

std::string surface_json(const Surface& surface) {
    const auto& [area, curves] = *surface.curves;
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
            if (samples[j].has_point()) {
                append_number(out, samples[j].y);
            } else {
                out += "null";
            }
            out += ']';
        }
        out += ']';
    }
    out += "]}";
    return out.string();
}

}  // namespace vidno
