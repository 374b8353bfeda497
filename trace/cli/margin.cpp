#include "margin/margin.h"

#include <charconv>
#include <iostream>

#include "cli/commands.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "refused.h"

namespace vidno::cli {

namespace {

struct MarginOptions : RunOptions {
    std::uint64_t step = 0;
    std::string vertex;
    bool json = false;
};

/// A polygon and one of its vertices, "A.2"; an id may have dots.
std::pair<PolygonPlace, int> vertex_in(const Scene& scene, const std::string& name) {
    const auto dot = name.rfind('.');
    const std::string id = name.substr(0, dot);
    const auto polygon = std::find_if(scene.polygons.begin(), scene.polygons.end(),
                                      [&](const ScenePolygon& each) { return each.id == id; });
    if (dot == std::string::npos || polygon == scene.polygons.end()) {
        throw Refused("--vertex " + name + ": not a vertex of a polygon of the scene, such as A.2");
    }
    int vertex = -1;
    const char* const end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + dot + 1, end, vertex);
    const int count = int(polygon->vertices.size());
    if (error != std::errc{} || rest != end || vertex < 0 || vertex >= count) {
        throw Refused("--vertex " + name + ": the vertices of " + id + " are 0 to " + std::to_string(count - 1));
    }
    return {{int(polygon - scene.polygons.begin())}, vertex};
}

int margin(const MarginOptions& options) {
    const NamedKernel kernel = kernel_of(options);
    const AdmittedScene scene = scene_for(kernel, scene_from(options.scene), options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    const auto [polygon, vertex] = vertex_in(scene, options.vertex);
    const Margin found = margin_of(request_of(options, kernel, scene), options.step, polygon, vertex);
    std::cout << (options.json ? margin_json(found, scene) : margin_text(found, scene));
    return 0;
}

}  // namespace

void add_margin(CLI::App& program, int& status) {
    auto& command =
        *program.add_subcommand("margin", "Find where a vertex may be moved without changing a sign of a step");
    const auto options = std::make_shared<MarginOptions>();
    add_run_options(command, *options, "A scene file, vidno-scene/1; - for standard input", "The algorithm [warnock]",
                    words(method_names));
    command
        .add_option("--step", options->step,
                    "A step with a sign, counted at level signs: in SurroundTest, PolygonClip, "
                    "TrialFunction, RayCrossings or OctantAngles")
        ->required();
    command
        .add_option("--vertex", options->vertex, "The vertex, counted from 0: A.2 is the third vertex of the polygon A")
        ->required();
    command.add_flag("--json", options->json, "As JSON, vidno-margin/1");
    command.footer(
        "The region is the intersection of the half-planes; each line says which signs change beyond it. All numbers "
        "are "
        "exact.\n"
        "Example: vidno margin scene.json --step 12 --vertex A.2");
    command.callback([options, &status] { status = margin(*options); });
}

}  // namespace vidno::cli
