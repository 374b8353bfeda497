#include "find/measures.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "check/check.h"
#include "choice/method.h"
#include "find/scene_size.h"
#include "listings_text.h"
#include "refused.h"
#include "scene/exact_scene.h"
#include "scene/snapped_scene.h"
#include "stability/shrink.h"
#include "vidno/resolution.h"

namespace vidno {

namespace {

const nlohmann::json& all_listings() {
    static const auto read = nlohmann::json::parse(figures::listings_text);
    return read;
}

/// The first part of a listing that has the line.
const nlohmann::json& procedure_with(Line line) {
    const std::string label(line_names[std::size_t(line)]);
    for (const auto& procedure : all_listings().at("procedures")) {
        for (const auto& each : procedure.at("lines")) {
            if (each.at("at") == label) return procedure;
        }
    }
    throw Refused("no listing has the line " + label);
}

bool lists_line(std::string_view method, Line line) {
    const auto& procedures = all_listings().at("methods").at(std::string(method));
    const auto& name = procedure_with(line).at("name");
    return std::find(procedures.begin(), procedures.end(), name) != procedures.end();
}

/// A colour of its own for each polygon, and another one for the background.
AdmittedScene distinguishable(Scene scene) {
    const auto color = [](std::size_t number) {
        return Color{std::uint8_t(number >> 16), std::uint8_t(number >> 8), std::uint8_t(number)};
    };
    for (std::size_t i = 0; i < scene.polygons.size(); ++i) scene.polygons[i].color = color(i);
    scene.background = color(scene.polygons.size());
    return exact_scene::admit(std::move(scene));
}

bool has_own_colors(const Scene& scene) {
    std::set<std::array<std::uint8_t, 3>> colors;
    const auto add = [&](const Color& color) { return colors.insert({color.red, color.green, color.blue}).second; };
    return add(scene.background) && std::all_of(scene.polygons.begin(), scene.polygons.end(),
                                                [&](const ScenePolygon& each) { return add(each.color); });
}

double pixels_showing(const std::string& id, const Scene& scene, const Picture& picture) {
    const auto& pixels = picture.pixels();
    std::ptrdiff_t count = 0;
    for (const auto& polygon : scene.polygons) {
        if (polygon.id == id) count += std::count(pixels.begin(), pixels.end(), polygon.color);
    }
    return double(count);
}

/// All pixels, if the scene is too wide for the kernel.
double wrong_pixels(const NamedKernel& kernel, Method method, const AdmittedScene& scene, const Picture& right) {
    if (kernel.snaps() && !fits_grid(scene, kernel.parameter)) return double(right.pixels().size());
    const AdmittedScene own = kernel.snaps() ? snapped_scene(scene, kernel.parameter).scene : scene;
    return double(different_pixels(run({method, kernel, Edition::corrected, own}), right));
}

double wrong_columns(const NamedKernel& kernel, const AdmittedCurves& scene, const DrawnLines& right) {
    const DrawnLines drawn = run(FloatingHorizonRequest{kernel, Edition::corrected, scene});
    return double(different_columns(columns_drawn(drawn, scene), columns_drawn(right, scene)));
}

/// The number of zeros, and the narrowest of the other decisions.
std::pair<double, double> narrow_decisions(const auto& request, Procedure procedure) {
    FindingList findings(procedure, request.scene->area, 1, 0);
    find_in(request, findings);
    double narrowest = std::numeric_limits<double>::infinity(), zeros = 0;
    for (const Finding& each : findings.findings()) {
        if (each.kind == FindingKind::narrow) narrowest = std::min(narrowest, std::abs(each.gap->ulps));
    }
    for (const auto& each : findings.zeros()) zeros += double(each.count);
    return {zeros, narrowest};
}

bool asks_for(const Condition& condition, auto... any) {
    const auto& names = condition.names();
    return std::any_of(names.begin(), names.end(), [&](const Name& name) { return ((name.quantity == any) || ...); });
}

bool asks_for_run(const Condition& condition) {
    const auto& names = condition.names();
    return !std::all_of(names.begin(), names.end(), [](const Name& name) { return name.choice().of_scene; });
}

std::vector<double> values_of_scene(const Condition& condition, const auto& scene) {
    std::vector<double> values;
    for (const Name& name : condition.names()) values.push_back(of_scene(name, scene));
    return values;
}

/// Runs the request, and reads each name's value. `pixels` and `wrong` take a name's argument and the run's result.
std::vector<double> values_of_run(const Condition& condition, auto request, Procedure procedure, const auto& pixels,
                                  const auto& wrong) {
    RunCounts counts;
    FunctionSink sink([&](const EventView& event) { counts.hear(event); });
    request.detail = Detail::signs;
    auto traced = request;
    traced.sink = &sink;
    const auto result = run(traced);
    std::pair<double, double> decisions;
    if (asks_for(condition, Quantity::zeros, Quantity::ulps)) decisions = narrow_decisions(request, procedure);
    std::vector<double> values;
    for (const Name& name : condition.names()) {
        switch (name.quantity) {
            case Quantity::pixels: values.push_back(pixels(name.argument, result)); break;
            case Quantity::wrong: values.push_back(wrong(name.kernel, result)); break;
            case Quantity::zeros: values.push_back(decisions.first); break;
            case Quantity::ulps: values.push_back(decisions.second); break;
            default: values.push_back(name.choice().of_scene ? of_scene(name, request.scene) : counts.of(name));
        }
    }
    return values;
}

/// Why a name does not suit a run of the method; empty if it does.
std::string unsuitable(const Name& name, std::string_view method) {
    const bool is_of_curves = method == floating_horizon_method;
    if (name.quantity == Quantity::line) {
        return lists_line(method, name.line) ? "" : "its listings have no line " + name.text();
    }
    if (name.choice().of == (is_of_curves ? QuantityOf::polygons : QuantityOf::curves)) {
        return name.text() + " is only for " + (is_of_curves ? "polygons" : "curves");
    }
    if (name.quantity != Quantity::wrong) return "";
    const KernelChoice& kernel = *name.kernel.choice;
    const bool runs = is_of_curves ? kernel.runs_floating_horizon(Edition::corrected)
                                   : kernel.runs(method_named(method), Edition::corrected);
    return runs ? "" : "not under the kernel of " + name.text();
}

}  // namespace

void RunCounts::come_to(Line line, std::size_t kind) {
    Frame& frame = frames_.back();
    const bool is_new = frame.at != line || frame.began == 0 || frame.began == kind;
    if (!is_new) return;
    frame = {line, kind};
    ++reached_[std::size_t(line)];
}

void RunCounts::hear(const EventView& event) {
    event.visit([&]<class E>(const E& e) {
        if constexpr (std::same_as<E, event::Disagree>) return;
        ++events_;
        if constexpr (requires { E::result_of; }) frames_.pop_back();
        // A frame begins with 0. The calls of each procedure are kinds of their own.
        std::size_t kind = 1 + event.place();
        if constexpr (std::same_as<E, event::Call>) kind += (1 + std::size_t(e.of)) * AllEvents::count;
        come_to(e.at, kind);
        if constexpr (std::same_as<E, event::Call>) frames_.emplace_back();
        if constexpr (std::same_as<E, event::Pop> || std::same_as<E, event::PopList>) {
            ++windows_;
            --stack_;
        }
        if constexpr (std::same_as<E, event::Push> || std::same_as<E, event::PushList>) {
            deepest_ = std::max(deepest_, ++stack_);
        }
        if constexpr (std::same_as<E, event::Decide>) splits_ += e.which == Case::split ? 1 : 0;
    });
}

double RunCounts::of(const Name& name) const {
    switch (name.quantity) {
        case Quantity::line: return double(reached(name.line));
        case Quantity::windows: return double(windows());
        case Quantity::splits: return double(splits());
        case Quantity::depth_of_stack: return double(depth_of_stack());
        case Quantity::events: return double(events());
        default: return 0;
    }
}

double of_scene(const Name& name, const Scene& scene) {
    if (name.quantity == Quantity::polygons) return double(scene.polygons.size());
    if (name.quantity == Quantity::vertices) return double(vertices_of(scene));
    return SceneSize(scene).coordinate();
}

double of_scene(const Name& name, const CurveScene& scene) {
    if (name.quantity == Quantity::curves) return double(scene.curves.size());
    if (name.quantity == Quantity::samples) return double(sample_count(scene));
    return SceneSize(scene).coordinate();
}

void expect_suits(const Condition& condition, std::string_view method) {
    for (const Name& name : condition.names()) {
        const std::string why = unsuitable(name, method);
        if (!why.empty()) throw Refused("--method " + std::string(method) + ": " + why);
    }
}

std::string_view method_for(const Condition& condition) {
    const auto suits = [&](std::string_view method) {
        return std::all_of(condition.names().begin(), condition.names().end(),
                           [&](const Name& name) { return unsuitable(name, method).empty(); });
    };
    for (const std::string_view method : method_names) {
        if (suits(method)) return method;
    }
    if (suits(floating_horizon_method)) return floating_horizon_method;
    throw Refused("no method has all names of the condition");
}

std::vector<double> measured(const Condition& condition, const AdmittedScene& given, Method method,
                             const NamedKernel& kernel) {
    if (!asks_for_run(condition)) return values_of_scene(condition, given);
    const bool shows_colors = asks_for(condition, Quantity::pixels, Quantity::wrong);
    const AdmittedScene scene = shows_colors && !has_own_colors(given) ? distinguishable(given) : given;
    return values_of_run(
        condition, RunRequest{method, kernel, Edition::corrected, scene}, choice_of(method).procedure,
        [&](const std::string& id, const Picture& picture) { return pixels_showing(id, scene, picture); },
        [&](const NamedKernel& by, const Picture& picture) { return wrong_pixels(by, method, scene, picture); });
}

std::vector<double> measured(const Condition& condition, const AdmittedCurves& scene, const NamedKernel& kernel) {
    if (!asks_for_run(condition)) return values_of_scene(condition, scene);
    return values_of_run(
        condition, FloatingHorizonRequest{kernel, Edition::corrected, scene}, Procedure::floating_horizon,
        [](const std::string&, const DrawnLines&) { return 0.; },  // expect_suits refuses it
        [&](const NamedKernel& by, const DrawnLines& lines) { return wrong_columns(by, scene, lines); });
}

std::vector<double> measured(const Condition& condition, const AnyScene& scene, std::string_view method,
                             const NamedKernel& kernel) {
    if (const auto* surface = std::get_if<Surface>(&scene)) return measured(condition, surface->curves, kernel);
    return measured(condition, std::get<AdmittedScene>(scene), method_named(method), kernel);
}

std::string text_of(Line line) {
    const std::string label(line_names[std::size_t(line)]);
    for (const auto& each : procedure_with(line).at("lines")) {
        if (each.at("at") == label) return each.at("en");
    }
    return {};
}

std::vector<std::string> methods_with(Line line) {
    std::vector<std::string> methods;
    for (const auto& [name, procedures] : all_listings().at("methods").items()) {
        if (lists_line(name, line)) methods.push_back(name);
    }
    return methods;
}

}  // namespace vidno
