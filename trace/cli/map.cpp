#include "sign_map/map.h"

#include <iomanip>
#include <iostream>

#include "commands.h"
#include "output.h"
#include "picture/image.h"
#include "sign_map/mapped_decision_json.h"

namespace vidno::cli {

namespace {

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

}  // namespace

int map(const MapOptions& options) {
    const std::string& output = options.output;
    if (output == "-") throw Refused("-: the table goes to standard output, the map to a .png, .ppm or .json file");
    const NamedKernel kernel = *kernel_named(options.kernel);
    if (kernel.snaps()) throw Refused("--kernel grid: the places of a map lie on no grid");
    const std::string text = read_file(options.decision);
    if (is_surface(text))
        throw Refused(options.decision + ": a surface, and no decision to be mapped, vidno-question/1");
    const MappedDecision decision = read_mapped_decision(text, options.decision);
    const SignMap drawn = sign_map(decision, kernel);
    if (!output.empty()) {
        OutputFile file(output);
        file.write(output.ends_with(".json") ? map_json(drawn) : encode_image(picture_of(drawn), output));
        file.commit();
    }
    print(drawn);
    return drawn.differing() > 0 ? 1 : 0;
}

}  // namespace vidno::cli
