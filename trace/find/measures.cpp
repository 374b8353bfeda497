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

/// The number of zeros, and the narrowest of the other decisions.
std::pair<double, double> narrow_decisions(const RunRequest& request) {
    FindingList findings(choice_of(request.method).procedure, request.scene->area, 1, 0);
    find_in(request, findings);
    double narrowest = std::numeric_limits<double>::infinity(), zeros = 0;
    for (const Finding& each : findings.findings()) {
        if (each.kind == FindingKind::narrow) narrowest = std::min(narrowest, std::abs(each.gap->ulps));
    }
    for (const auto& each : findings.zeros()) zeros += double(each.count);
    return {zeros, narrowest};
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

void expect_suits(const Condition& condition, Method method) {
    const std::string named = "--method " + std::string(method_names[std::size_t(method)]);
    for (const Name& name : condition.names()) {
        if (name.quantity == Quantity::line && !lists_line(method_names[std::size_t(method)], name.line)) {
            throw Refused(named + ": its listings have no line " + name.text());
        }
        if (name.quantity == Quantity::wrong && !name.kernel.choice->runs(method, Edition::corrected)) {
            throw Refused(named + ": not under the kernel of " + name.text());
        }
    }
}

Method method_for(const Condition& condition) {
    for (std::size_t i = 0; i < method_names.size(); ++i) {
        const auto is_in = [&](const Name& name) {
            return name.quantity != Quantity::line || lists_line(method_names[i], name.line);
        };
        if (std::all_of(condition.names().begin(), condition.names().end(), is_in)) return Method(i);
    }
    throw Refused("no method for polygons has all lines of the condition");
}

std::vector<double> measured(const Condition& condition, const AdmittedScene& given, Method method,
                             const NamedKernel& kernel) {
    const auto& names = condition.names();
    const auto asks = [&](auto... any) {
        return std::any_of(names.begin(), names.end(),
                           [&](const Name& name) { return ((name.quantity == any) || ...); });
    };
    const auto is_of_run = [](const Name& name) { return !name.choice().of_scene; };
    std::vector<double> values;
    if (std::none_of(names.begin(), names.end(), is_of_run)) {
        for (const Name& name : names) values.push_back(of_scene(name, given));
        return values;
    }

    const bool recolored = asks(Quantity::pixels, Quantity::wrong) && !has_own_colors(given);
    const AdmittedScene scene = recolored ? distinguishable(given) : given;
    RunCounts counts;
    FunctionSink sink([&](const EventView& event) { counts.hear(event); });
    const Picture picture = run({method, kernel, Edition::corrected, scene, Detail::signs, &sink});
    std::pair<double, double> decisions;
    if (asks(Quantity::zeros, Quantity::ulps)) {
        decisions = narrow_decisions({method, kernel, Edition::corrected, scene, Detail::signs});
    }
    for (const Name& name : names) {
        switch (name.quantity) {
            case Quantity::polygons:
            case Quantity::vertices:
            case Quantity::coordinates: values.push_back(of_scene(name, scene)); break;
            case Quantity::pixels: values.push_back(pixels_showing(name.argument, scene, picture)); break;
            case Quantity::wrong: values.push_back(wrong_pixels(name.kernel, method, scene, picture)); break;
            case Quantity::zeros: values.push_back(decisions.first); break;
            case Quantity::ulps: values.push_back(decisions.second); break;
            default: values.push_back(counts.of(name));
        }
    }
    return values;
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
