#include "chart.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "method.h"
#include "scene_json.h"
#include "snapped_scene.h"
#include "timing.h"
#include "vidno/kernels/depth_bits.h"
#include "vidno/kernels/machine.h"

namespace vidno {

const std::array<CostAxis, 3> cost_axes{{
    {"time", [](const ChartRun& run) { return std::optional(run.cost.time); }},
    {"operations", [](const ChartRun& run) { return std::optional(run.cost.operations); }},
    {"bits", [](const ChartRun& run) { return run.cost.bits; }},
}};

const std::array<ErrorAxis, 4> error_axes{{
    {"wrongPixels", [](const ChartRun& run) { return double(run.found.wrong_pixels); }},
    {"area", [](const ChartRun& run) { return run.found.area; }},
    {"wrongDecisions",
     [](const ChartRun& run) {
         return run.found.decisions == 0 ? 0 : double(run.found.wrong_decisions) / double(run.found.decisions);
     }},
    {"depthUlps", [](const ChartRun& run) { return run.found.depth_ulps; }},
}};

namespace {

// ------------------------------------------------------------------------------------- ways

std::vector<Way> fixed_ways(Method method) {
    std::vector<Way> ways;
    for (const auto& choice : kernel_choices) {
        if (choice.parameter) continue;
        for (const Edition edition : {Edition::corrected, Edition::printed}) {
            if (choice.runs(method, edition)) ways.push_back({method, {&choice}, edition});
        }
    }
    return ways;
}

std::vector<Way> turned(Method method, Knob knob, std::string_view kernel, int least, int most) {
    std::vector<Way> ways;
    for (int value = least; value <= most; ++value) {
        const std::string name = std::string(kernel) + ":" + std::to_string(value);
        ways.push_back({method, *kernel_named(name), Edition::corrected, 1, knob, value});
    }
    return ways;
}

/// Of a method that is compared with the course's no knob is turned: its numbers have few bits, or a grid, in one run each.
std::vector<Way> compared_ways(Method method, const Scene& scene) {
    if (refusal_of(method, scene)) return {};
    auto ways = fixed_ways(method);
    for (const auto* kernel : {"bits:12", "grid:8"}) {
        const auto named = *kernel_named(kernel);
        if (!named.choice->runs(method, Edition::corrected)) continue;
        if (!named.snaps() || named.parameter <= finest_grid_of(scene)) ways.push_back({method, named});
    }
    return ways;
}

std::vector<Way> larger_windows(const Scene& scene) {
    std::vector<Way> ways;
    const auto largest = int(covering_square(scene.area).width);
    for (int side = 2; side <= largest; side *= 2) {
        ways.push_back({Method::warnock, *kernel_named("double"), Edition::corrected, side, Knob::window, side});
    }
    return ways;
}

// ------------------------------------------------------------------------------------- cost

/// The bits of a kernel's numbers, if they have one width; x and y of a grid are whole numbers.
std::optional<int> bits_of(const NamedKernel& kernel, const Scene& scene) {
    const auto name = kernel.choice->name;
    if (name == Float::name) return std::numeric_limits<float>::digits;
    if (name == Double::name || name == DepthBits::name) return std::numeric_limits<double>::digits;
    if (name == Bits::name) return kernel.parameter;
    if (kernel.snaps()) return std::ilogb(std::ldexp(farthest_out(scene), kernel.parameter)) + 1;
    return std::nullopt;
}

Cost cost_of(const Way& way, const Scene& scene, const OperationCounts& counts) {
    Cost cost;
    cost.operations = double(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    if (const auto bits = bits_of(way.kernel, scene)) {
        const auto comparisons = double(counts[std::size_t(Operation::comparisons)]);
        const int stored = way.knob == Knob::depth ? way.value : *bits;
        cost.bits = (cost.operations - comparisons) * *bits + comparisons * stored;
    }
    return cost;
}

// ------------------------------------------------------------------------------------- fronts

/// The runs to which none is preferred: one that is better in one of both and as good in the other, or an equal one that
/// comes before. A run that a fault ended is not among them.
void mark_front(std::vector<ChartRun>& runs, std::size_t cost, std::size_t error) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].found.complete && cost_axes[cost].of(runs[i])) order.push_back(i);
    }
    const auto place = [&](std::size_t i) {
        return std::tuple(*cost_axes[cost].of(runs[i]), error_axes[error].of(runs[i]), i);
    };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return place(i) < place(j); });
    std::optional<double> least_error;
    for (const std::size_t i : order) {
        const double own_error = error_axes[error].of(runs[i]);
        if (least_error && own_error >= *least_error) continue;
        least_error = own_error;
        runs[i].on_front[cost][error] = true;
    }
}

/// The relative times and the fronts, of runs that were all measured.
void compare_runs(std::vector<ChartRun>& runs) {
    const auto faster = [](const auto& a, const auto& b) { return a.cost.seconds < b.cost.seconds; };
    const double fastest = std::min_element(runs.begin(), runs.end(), faster)->cost.seconds;
    for (auto& run : runs) {
        run.cost.time = run.cost.seconds / fastest;
        run.on_front = {};
    }
    for (std::size_t cost = 0; cost < cost_axes.size(); ++cost) {
        for (std::size_t error = 0; error < error_axes.size(); ++error) mark_front(runs, cost, error);
    }
}

// ------------------------------------------------------------------------------------- scenes

/// A scene as the kernels run it.
class Stage {
public:
    explicit Stage(const Scene& scene) : as_it_is_{scene, std::vector<std::size_t>(scene.polygons.size()), {}} {
        std::iota(as_it_is_.sources.begin(), as_it_is_.sources.end(), std::size_t{0});
    }

    const SnappedScene& scene_for(const NamedKernel& kernel) {
        if (!kernel.snaps()) return as_it_is_;
        const auto known = snapped_.find(kernel.parameter);
        if (known != snapped_.end()) return known->second;
        return snapped_.emplace(kernel.parameter, snapped_scene(as_it_is_.scene, kernel.parameter)).first->second;
    }

private:
    SnappedScene as_it_is_;
    std::map<int, SnappedScene> snapped_;  // by the bits of the grid
};

}  // namespace

std::vector<Way> ways_to_draw(const Scene& scene) {
    std::vector<Way> ways;
    const auto add = [&](const std::vector<Way>& more) { ways.insert(ways.end(), more.begin(), more.end()); };
    for (const Method method : course_methods) {
        add(fixed_ways(method));
        add(turned(method, Knob::bits, Bits::name, fewest_bits, most_bits));
        add(turned(method, Knob::grid, Grid::name, 1, finest_grid_of(scene)));
    }
    add(turned(Method::zbuffer, Knob::depth, DepthBits::name, fewest_depth_bits, most_depth_bits));
    add(larger_windows(scene));
    for (std::size_t place = 0; place < method_names.size(); ++place) {
        if (!is_of_course(Method(place))) add(compared_ways(Method(place), scene));
    }
    return ways;
}

std::size_t turns_of(const Scene& scene) { return ways_to_draw(scene).size() * (1 + chart_rounds); }

SceneChart chart_of(const Scene& scene, const std::function<void()>& progress) {
    Stage stage(scene);
    const Examiner examiner(scene);
    SceneChart chart{scene.name, examiner.unsteady_pixels(), examiner.pixels(), scene.polygons.size(),
                     examiner.area_of_pixels()};
    chart.scene = scene_json(scene);
    std::vector<RunRequest> requests;
    for (const Way& way : ways_to_draw(scene)) {
        const SnappedScene& as_run = stage.scene_for(way.kernel);
        RunRequest request{way.method, way.kernel, way.edition, as_run.scene};
        request.smallest_window = way.smallest_window;
        const Findings found = examiner.examine(request, as_run.sources);
        chart.runs.push_back({way, cost_of(way, scene, found.operations), found});
        requests.push_back(std::move(request));
        progress();
    }
    const auto seconds = median_seconds(requests, chart_rounds, progress);
    for (std::size_t i = 0; i < seconds.size(); ++i) chart.runs[i].cost.seconds = seconds[i];
    compare_runs(chart.runs);
    return chart;
}

SceneChart for_page(SceneChart chart) {
    std::erase_if(chart.runs, [](const ChartRun& run) { return run.way.method == Method::weiler_atherton; });
    compare_runs(chart.runs);
    return chart;
}

}  // namespace vidno
