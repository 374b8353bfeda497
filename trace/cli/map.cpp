#include "sign_map/map.h"

#include <iomanip>
#include <iostream>

#include "cli/commands.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "output.h"
#include "picture/image.h"
#include "sign_map/failed_decision.h"
#include "sign_map/mapped_decision_json.h"

namespace vidno::cli {

namespace {

struct MapOptions {
    std::string decision, output;  // no output: the table alone
    std::string kernel = "double";
};

void print(const SignMap& map) {
    const auto counts = map.counts();
    const auto row = [&](std::string_view name, auto&& cell_of) {
        std::cout << std::left << std::setw(12) << name << std::right;
        for (std::size_t i = 0; i < map.answers.size(); ++i) {
            const auto& exact = map.answers[i];
            if (!exact.empty()) std::cout << std::setw(int(exact.size()) + 12) << cell_of(i);
        }
        std::cout << '\n';
    };
    std::cout << map.decision << " under " << map.kernel << '\n';
    row("computed", [&](std::size_t exact) { return "exactly " + std::string(map.answers[exact]); });
    for (std::size_t i = 0; i < map.answers.size(); ++i) {
        const auto& computed = map.answers[i];
        if (!computed.empty()) row(computed, [&](std::size_t exact) { return counts[i][exact]; });
    }
    std::cout << "differ: " << map.differing() << " of " << map.cells.size() << '\n';
}

/// The decision of a file: a decision file, or the one at which a failure goes wrong.
MappedDecision decision_in(const std::string& file) {
    const std::string text = read_text(file);
    if (is_surface(text)) throw Refused(file + ": a surface, not a decision to map, vidno-question/1");
    if (!is_failure(text)) return read_mapped_decision(text, file);
    const Failure failure = read_failure(text, file);
    say(failure, file);
    return failed_decision(failure, file);
}

int map(const MapOptions& options) {
    const std::string& output = options.output;
    if (output == "-")
        throw Refused("-: only the table goes to standard output; the map needs a .png, .ppm or .json file");
    const NamedKernel kernel = *kernel_named(options.kernel);
    if (kernel.snaps()) throw Refused("--kernel grid: the places of a map do not lie on a grid");
    const MappedDecision decision = decision_in(options.decision);
    const SignMap drawn = sign_map(decision, kernel);
    if (!output.empty()) {
        OutputFile file(output);
        file.write(output.ends_with(".json") ? map_json(drawn) : encode_image(picture_of(drawn), output));
        file.commit();
    }
    print(drawn);
    return drawn.differing() > 0 ? 1 : 0;
}

}  // namespace

void add_map(CLI::App& program, int& status) {
    auto& command =
        *program.add_subcommand("map", "Take one decision at 256 x 256 places of a point, beside the exact one");
    const auto options = std::make_shared<MapOptions>();
    command.add_option("DECISION", options->decision, "A decision file, vidno-question/1; - for standard input")
        ->required();
    command.add_option("--kernel", options->kernel, "The arithmetic")->check(a_kernel())->capture_default_str();
    command.add_option("-o", options->output,
                       "The map, .png or .ppm; or .json, with how often each answer is right and wrong");
    command.footer(
        "In the picture orange is negative, blue is positive, and white or black is zero. Dark places are wrong.\n"
        "Example: vidno map lessons/maps/kettner-2a.json -o a.png\n"
        "Exit status 1: the answer is wrong at some place.");
    command.callback([options, &status] { status = map(*options); });
}

}  // namespace vidno::cli
