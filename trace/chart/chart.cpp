#include "chart/chart.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "chart/chart_pictures.h"
#include "chart/timing.h"
#include "choice/method.h"
#include "scene/scene_json.h"
#include "scene/snapped_scene.h"
#include "vidno/kernels/depth_bits.h"
#include "vidno/kernels/machine.h"

namespace vidno {

const CostAxes<ChartRun, 3> cost_axes{{
    {"time", [](const ChartRun& run) { return std::optional(run.cost.time); }},
    {"operations", [](const ChartRun& run) { return std::optional(run.cost.operations); }},
    {"bits", [](const ChartRun& run) { return run.cost.bits; }},
}};

const ErrorAxes<ChartRun, 4> error_axes{{
    {"wrongPixels", [](const ChartRun& run) { return double(run.found.wrong_pixels); }},
    {"area", [](const ChartRun& run) { return run.found.area; }},
    wrong_decisions_axis<ChartRun>,
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

/// A method outside the course has one setting of each knob: few bits in one run, a grid in another.
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
        ways.push_back(
            {Method::warnock, kernel_of(KernelKind::binary64), Edition::corrected, side, Knob::window, side});
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

// ------------------------------------------------------------------------------------- scenes

/// A scene as the kernels run it.
class Stage {
public:
    explicit Stage(const AdmittedScene& scene)
        : as_it_is_{scene, std::vector<std::size_t>(scene->polygons.size()), {}} {
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

SceneChart chart_of(const AdmittedScene& scene, const std::function<void()>& progress) {
    Stage stage(scene);
    const Examiner examiner(scene);
    SceneChart chart{scene->name, examiner.unsteady_pixels(), examiner.right().pixels().size(), scene->polygons.size(),
                     examiner.area_of_pixels()};
    chart.scene = scene_json(scene);
    ScenePictures pictures(scene->area.width, examiner.right().pixels());
    std::vector<std::function<void()>> runs;
    for (const Way& way : ways_to_draw(scene)) {
        const SnappedScene& as_run = stage.scene_for(way.kernel);
        RunRequest request{way.method, way.kernel, way.edition, as_run.scene};
        request.smallest_window = way.smallest_window;
        Findings found = examiner.examine(request, as_run.sources);
        const std::size_t picture = pictures.place_of(std::exchange(found.pixels, {}));
        chart.runs.push_back({way, cost_of(way, scene, found.operations), found, {}, picture});
        runs.emplace_back([request] { run(request); });
        progress();
    }
    const auto seconds = median_seconds(runs, chart_rounds, progress);
    for (std::size_t i = 0; i < seconds.size(); ++i) chart.runs[i].cost.seconds = seconds[i];
    chart.pictures = pictures.json();
    compare_runs(chart.runs, cost_axes, error_axes);
    return chart;
}

}  // namespace vidno
