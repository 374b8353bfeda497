/// Axes: the costs and errors of the runs of a chart, and their Pareto fronts.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

namespace vidno {

/// By the names used in files.
template <class Run>
struct CostAxis {
    std::string_view name;
    std::optional<double> (*of)(const Run&);
};
template <class Run>
struct ErrorAxis {
    std::string_view name;
    double (*of)(const Run&);
};

/// The share of wrong decisions among those whose truth is known, since runs take different numbers of decisions. 0 if
/// there are none.
template <class Run>
inline constexpr ErrorAxis<Run> wrong_decisions_axis{
    "wrongDecisions", [](const Run& run) {
        return run.found.decisions == 0 ? 0 : double(run.found.wrong_decisions) / double(run.found.decisions);
    }};

template <class Run, std::size_t count>
using CostAxes = std::array<CostAxis<Run>, count>;
template <class Run, std::size_t count>
using ErrorAxes = std::array<ErrorAxis<Run>, count>;

/// For each cost and error, by index: is the run on the front? No other run is better in one and at least as good in
/// the other, and no equal one comes before it.
template <std::size_t costs, std::size_t errors>
using Fronts = std::array<std::array<bool, errors>, costs>;

/// Sets the times of measured runs relative to the fastest, and the fronts. A run that ended by a fault is on no front.
template <class Run, std::size_t costs, std::size_t errors>
void compare_runs(std::vector<Run>& runs, const CostAxes<Run, costs>& cost_axes,
                  const ErrorAxes<Run, errors>& error_axes) {
    const auto faster = [](const Run& a, const Run& b) { return a.cost.seconds < b.cost.seconds; };
    const double fastest = std::min_element(runs.begin(), runs.end(), faster)->cost.seconds;
    for (Run& run : runs) {
        run.cost.time = run.cost.seconds / fastest;
        run.on_front = {};
    }
    for (std::size_t cost = 0; cost < costs; ++cost) {
        std::vector<Run*> costly;
        for (Run& run : runs) {
            if (run.is_complete() && cost_axes[cost].of(run)) costly.push_back(&run);
        }
        for (std::size_t error = 0; error < errors; ++error) {
            const auto place = [&](const Run* run) {
                return std::tuple(*cost_axes[cost].of(*run), error_axes[error].of(*run), run);
            };
            std::sort(costly.begin(), costly.end(), [&](auto* a, auto* b) { return place(a) < place(b); });
            std::optional<double> least_error;
            for (Run* run : costly) {
                const double own_error = error_axes[error].of(*run);
                if (least_error && own_error >= *least_error) continue;
                least_error = own_error;
                run->on_front[cost][error] = true;
            }
        }
    }
}

}  // namespace vidno
