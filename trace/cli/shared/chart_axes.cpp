#include "cli/shared/chart_axes.h"

#include <algorithm>

#include "chart/chart.h"
#include "cli/shared/run_options.h"
#include "refused.h"

namespace vidno::cli {

namespace {

/// The names of the items, in their order.
std::vector<std::string> names_of(const auto& named) {
    std::vector<std::string> names;
    for (const auto& each : named) names.emplace_back(each.name);
    return names;
}

/// The index of an axis; the first one if none is named.
std::size_t place_of(const std::string& option, const std::optional<std::string>& name, const auto& axes) {
    if (!name) return 0;
    const auto names = names_of(axes);
    const std::size_t place = place_in(names, *name);
    if (place < names.size()) return place;
    std::string there;
    for (const auto& each : names) there += (there.empty() ? "" : ", ") + each;
    throw Refused(option + " " + *name + ": this chart has " + there);
}

/// The indices of the cost and of the error.
std::pair<std::size_t, std::size_t> places_of(const AxisOptions& axes, const auto& costs, const auto& errors) {
    return {place_of("--cost", axes.cost, costs), place_of("--error", axes.error, errors)};
}

}  // namespace

void add_axes(CLI::App& command, AxisOptions& axes, const std::string& cost) {
    const auto all = [](auto names, const auto& more) {
        for (const auto& name : more) {
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
        return names;
    };
    command.add_option("--cost", axes.cost, cost)
        ->check(CLI::IsMember(all(names_of(cost_axes), names_of(surface_cost_axes))));
    command.add_option("--error", axes.error, "The vertical axis [wrongPixels; for surfaces wrongColumns]")
        ->check(CLI::IsMember(all(names_of(error_axes), names_of(surface_error_axes))));
}

void expect_axes(const AxisOptions& axes, bool of_surfaces) {
    if (of_surfaces) {
        places_of(axes, surface_cost_axes, surface_error_axes);
    } else {
        places_of(axes, cost_axes, error_axes);
    }
}

std::vector<figures::ChartPanel> panels_of(const AnyChart& chart, const AxisOptions& axes, Language language) {
    std::vector<figures::ChartPanel> panels;
    const auto add_all = [&](const auto& subjects, const auto& costs, const auto& errors) {
        const auto [cost, error] = places_of(axes, costs, errors);
        for (const auto& subject : subjects) panels.push_back(figures::panel_of(subject, cost, error, language));
    };
    if (const auto* scenes = std::get_if<std::vector<SceneChart>>(&chart)) {
        auto ordered = *scenes;
        std::stable_partition(ordered.begin(), ordered.end(),
                              [](const SceneChart& scene) { return !scene.degenerate(); });
        add_all(ordered, cost_axes, error_axes);
    } else {
        add_all(std::get<std::vector<SurfaceChart>>(chart), surface_cost_axes, surface_error_axes);
    }
    return panels;
}

double usual_width_of(const std::vector<figures::ChartPanel>& panels) {
    constexpr double column = 80, page = 170;
    return panels.size() == 1 ? column : page;
}

}  // namespace vidno::cli
