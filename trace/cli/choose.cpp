#include <algorithm>
#include <iomanip>
#include <iostream>

#include "chart/timing.h"
#include "check/check.h"
#include "choice/method.h"
#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/scene_files.h"
#include "counted.h"
#include "scene/snapped_scene.h"

namespace vidno::cli {

namespace {

struct ChooseOptions {
    std::string scene;
};

struct Candidate {
    Method method;
    NamedKernel kernel;
    AdmittedScene scene;  // as the kernel runs it
    std::size_t wrong_pixels = 0;
    double seconds = 0;

    RunRequest request() const { return {method, kernel, Edition::corrected, scene}; }
};

/// Each method that paints the picture rule, under each kernel that is cheaper than exact rationals and takes the
/// scene. Methods that do more than paint are left out.
std::vector<Candidate> candidates_for(const AdmittedScene& scene) {
    const NamedKernel grid = kernel_of(KernelKind::grid);
    std::optional<AdmittedScene> on_grid;
    if (fits_grid(scene, grid.parameter)) on_grid = snapped_scene(scene, grid.parameter).scene;
    std::vector<Candidate> candidates;
    for (std::size_t place = 0; place < method_names.size(); ++place) {
        const auto method = Method(place);
        if (reference_of(method) != Method::zbuffer || refusal_of(method, scene)) continue;
        if (method == Method::weiler_atherton) continue;
        for (const std::string name : {"float", "double", "filtered"}) {
            candidates.push_back({method, *kernel_named(name), scene});
        }
        if (on_grid) candidates.push_back({method, grid, *on_grid});
    }
    return candidates;
}

std::string name_of(const Candidate& candidate) {
    return std::string(method_names[std::size_t(candidate.method)]) + " under " + candidate.kernel.name();
}

std::uint64_t sum_of(const auto& counts) {
    std::uint64_t sum = 0;
    for (const auto count : counts) sum += count;
    return sum;
}

/// Confirms that the picture is right: compares each decision of the run under `filtered` with exact arithmetic. False
/// if one was not confirmed.
bool print_certificate(const Candidate& chosen, const AdmittedScene& scene) {
    const RunRequest filtered{chosen.method, kernel_of(KernelKind::filtered), Edition::corrected, scene};
    const CheckReport certain = check_run(filtered, right_picture(scene));
    const auto& by = certain.decided_by;
    std::cout << "certificate: its picture is that of " << method_names[std::size_t(chosen.method)]
              << " under filtered, which made " << counted(sum_of(by), "comparison", "comparisons")
              << ";\n  coordinates as given decided " << by[std::size_t(FilterStage::given)]
              << " of them, an error bound "
              << by[std::size_t(FilterStage::scene)] + by[std::size_t(FilterStage::operands)]
              << ", and what no bound could decide, " << by[std::size_t(FilterStage::exact)]
              << ", exact arithmetic;\n  a run in exact rationals "
              << (certain.found_something() ? "did not agree" : "agreed") << " with all of its decisions\n";
    return !certain.found_something();
}

int choose(const ChooseOptions& options) {
    const AdmittedScene scene = scene_from(options.scene);
    auto candidates = candidates_for(scene);
    const Picture right = run({Method::zbuffer, kernel_of(KernelKind::filtered), Edition::corrected, scene});
    std::vector<std::function<void()>> runs;
    for (auto& candidate : candidates) {
        candidate.wrong_pixels = different_pixels(run(candidate.request()), right);
        runs.emplace_back([request = candidate.request()] { run(request); });
    }
    Progress progress("runs");
    const auto seconds = median_seconds(runs, 5, [&, done = 0ULL]() mutable { progress.show(++done); });
    progress.clear();
    for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].seconds = seconds[i];

    const auto cheaper = [](const auto& a, const auto& b) { return a.seconds < b.seconds; };
    std::stable_sort(candidates.begin(), candidates.end(), cheaper);
    const auto is_right = [](const auto& candidate) { return candidate.wrong_pixels == 0; };
    const Candidate& chosen = *std::find_if(candidates.begin(), candidates.end(), is_right);  // `filtered` always is
    std::cout << "method            kernel      time  wrong pixels\n" << std::fixed << std::setprecision(2);
    for (const auto& candidate : candidates) {
        std::cout << std::left << std::setw(18) << method_names[std::size_t(candidate.method)] << std::setw(10)
                  << candidate.kernel.name() << std::right << std::setw(6)
                  << candidate.seconds / candidates.front().seconds << std::setw(14) << candidate.wrong_pixels << '\n';
    }
    std::cout << "choose " << name_of(chosen) << '\n';
    return print_certificate(chosen, scene) ? 0 : 1;
}

}  // namespace

void add_choose(CLI::App& program, int& status) {
    auto& command =
        *program.add_subcommand("choose", "Find the cheapest method and kernel with a picture that is certainly right");
    const auto options = std::make_shared<ChooseOptions>();
    command.add_option("SCENE", options->scene, "A scene file, vidno-scene/1, or a failure; - for standard input")
        ->required();
    command.footer("Times are medians of five interleaved runs, relative to the fastest.");
    command.callback([options, &status] { status = choose(*options); });
}

}  // namespace vidno::cli
