#include "proof/why.h"

#include <iostream>

#include "check/check.h"
#include "choice/method.h"
#include "cli/commands.h"
#include "cli/shared/polygon_scene.h"
#include "cli/shared/read_numbers.h"
#include "cli/shared/run_options.h"
#include "json/json_text.h"
#include "refused.h"

namespace vidno::cli {

namespace {

struct WhyOptions : RunOptions {
    std::string pixel, language = "en";
    bool json = false;
};

bool contains(const PixelRectangle& pixels, Pixel at) {
    return pixels.x <= at.x && at.x < pixels.x + pixels.width && pixels.y <= at.y && at.y < pixels.y + pixels.height;
}

/// What the run decided wrongly where it changes the pixel first.
std::string decision_text(const Finding& finding, Language language) {
    const std::string place = std::to_string(finding.step) + ", " + std::string(line_names[std::size_t(finding.at)]) +
                              " (" + std::string(procedure_names[std::size_t(finding.procedure)]) + ")";
    const bool rounded = finding.decision.cause() == Cause::rounded;
    if (language == Language::russian) {
        return "решение на шаге " + place +
               " неверно: " + (rounded ? "эта операция округлена" : "её операнды уже отошли от точных");
    }
    return "the decision at step " + place +
           " is wrong: " + (rounded ? "its operation rounded" : "its operands had already drifted");
}

/// Runs the method and compares the pixel with the picture rule. Returns the exit status.
int print_run(const WhyOptions& options, const AdmittedScene& given, Pixel at, std::optional<int> owner) {
    const Language language = Language(place_in(language_codes, options.language));
    const NamedKernel kernel = kernel_of(options);
    const AdmittedScene scene = scene_for(kernel, given, options.scene);
    expect_admitted(method_of(options), scene, options.scene);
    const RunRequest request = request_of(options, kernel, scene);
    const Color right = owner ? given->polygons[std::size_t(*owner)].color : given->background;
    const Color painted = run(request).at(at.x, at.y);
    if (painted == right) return 0;
    std::cout << Bilingual{"the run paints ", "вычисление красит "}.in(language) << hex_of(painted)
              << Bilingual{" where the colour must be ", " там, где цвет должен быть "}.in(language) << hex_of(right);
    FindingList list(choice_of(request.method).procedure, scene->area, 0);
    check_run(
        request, right_picture(scene, request.method), [](const auto&) {}, &list);
    for (const Finding& finding : list.findings()) {
        if (finding.kind != FindingKind::wrong || !contains(finding.pixels, at)) continue;
        std::cout << ": " << decision_text(finding, language);
        break;
    }
    std::cout << '\n';
    return 1;
}

int why(WhyOptions options) {
    const AdmittedScene scene = polygon_scene_for(options);
    const Pixel at = pixel_in(options.pixel, scene->area);
    const Reasons reasons(scene);
    if (options.json) {
        std::cout << why_json(reasons, at.x, at.y, scene);
        return 0;
    }
    std::cout << why_text(reasons, at.x, at.y, scene, Language(place_in(language_codes, options.language)));
    return print_run(options, scene, at, reasons.owner(at.x, at.y));
}

}  // namespace

void add_why(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("why", "Say why a pixel has its colour, in exact numbers");
    const auto options = std::make_shared<WhyOptions>();
    add_run_options(
        command, *options,
        "A scene file, vidno-scene/1; or a failure, vidno-failure/1, whose failing run is the default; - for "
        "standard input",
        "The algorithm [warnock]", words(method_names));
    command.add_option("--pixel", options->pixel, "The pixel, as column,row")->required()->type_name("X,Y");
    command.add_option("--language", options->language, "The language of the sentences")
        ->check(CLI::IsMember(words(language_codes)))
        ->capture_default_str();
    command.add_flag("--json", options->json, "The reasons as JSON, vidno-why/1; nothing runs");
    command.footer(
        "Each polygon has a sentence: why it shows or not, and the smallest change that would change this. Depths and\n"
        "distances are exact fractions.\n"
        "Example: vidno why scene.json --pixel 3,4 --kernel float\n"
        "Exit status 1: the run paints the pixel wrong; the last line names the decision that did it.");
    command.callback([options, &status] { status = why(*options); });
}

}  // namespace vidno::cli
