#include "stability/need.h"

#include <iomanip>
#include <iostream>

#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/scene_files.h"
#include "output.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

struct NeedOptions {
    std::string scene, output;  // the output may be empty
};

int need(const NeedOptions& options) {
    const AdmittedScene scene = scene_from(options.scene);
    Progress progress("pictures");
    const NeedReport report = needs_of(scene, [&, pictures = 0ULL]() mutable { progress.show(++pictures); });
    progress.clear();
    if (!options.output.empty()) {
        OutputFile file(options.output);
        file.write(scene_json(report.least) + '\n');
        file.commit();
    }
    std::cout << std::left << std::setw(32) << "the picture needs" << std::setw(14) << ""
              << "one less\n";
    for (const auto& [what, amount, one_lower] : report.needs) {
        std::cout << std::setw(32) << what << std::setw(14) << amount << (one_lower.empty() ? "-" : one_lower) << '\n';
    }
    return 0;
}

}  // namespace

void add_need(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("need", "Find how little of a scene, and of arithmetic, its picture needs");
    const auto options = std::make_shared<NeedOptions>();
    command.add_option("SCENE", options->scene, "A scene file, vidno-scene/1, or a failure; - for standard input")
        ->required();
    command.add_option("-o", options->output, "The polygons and vertices that are needed, as a scene");
    command.footer(
        "Each line says what one less would change. The command first leaves out polygons and vertices, and then\n"
        "tests everything else on the remaining scene, one thing at a time.");
    command.callback([options, &status] { status = need(*options); });
}

}  // namespace vidno::cli
