#include "homework/exercises.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "choice/method.h"
#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "homework/profile.h"
#include "output.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

struct HomeworkOptions {
    std::string scene, output;
    std::string method = "warnock";
    std::size_t count = 30;
    std::uint64_t seed = 1;
};

/// From 01, with as many digits as the last number, so that names sort as numbers.
std::string number_of(std::size_t place, std::size_t count) {
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(count).size());
    const std::string number = std::to_string(place + 1);
    return std::string(digits - number.size(), '0') + number;
}

int homework(const HomeworkOptions& options) {
    const std::filesystem::path folder(options.output);
    if (std::filesystem::exists(folder)) throw Refused(options.output + " already exists");
    const auto method = method_named(options.method);
    const auto [scene, note] = by_hand(scene_from(options.scene), method, options.scene);
    if (!note.empty()) std::cerr << options.scene << ": " << note << '\n';
    Progress progress("exercises");
    auto found = exercises_of(scene, method, options.count, options.seed,
                              [&](std::size_t so_far) { progress.show(so_far, options.count); });
    progress.clear();
    const auto has_long_numbers = [&](const AdmittedScene& exercise) {
        return profiled_run(exercise, method).long_numbers > 0;
    };
    if (std::any_of(found.begin(), found.end(), has_long_numbers)) {
        std::cerr << options.scene << ": no scenes with only short slopes and depths were found; some are longer\n";
    }
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Refused(options.output + ": cannot be made: " + error.message());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::string number = number_of(i, options.count);
        Scene exercise = found[i];
        exercise.name += (exercise.name.empty() ? "" : " · ") + number;
        write_file(folder / (number + ".json"), scene_json(exercise) + '\n');
    }
    if (found.size() == options.count) return 0;
    std::cerr << options.output << ": " << found.size() << " of " << options.count
              << " exercises: no more were found (another --seed may find more)\n";
    return 1;
}

void describe_homework(CLI::App& command, int& status) {
    const auto options = std::make_shared<HomeworkOptions>();
    command.add_option("SCENE", options->scene, "A scene file, vidno-scene/1, or a failure; - for standard input")
        ->required();
    command.add_option("--count", options->count, "The number of scenes")
        ->check(CLI::Range(std::size_t{1}, most_exercises))
        ->capture_default_str();
    command.add_option("--seed", options->seed, "The seed; another seed gives other scenes")->capture_default_str();
    command.add_option("--method", options->method, "The algorithm for which they are equally hard")
        ->check(CLI::IsMember(words(course_method_names)))
        ->capture_default_str();
    command.add_option("-o", options->output, "The folder for 01.json, 02.json and so on; it must not exist yet")
        ->required();
    command.footer(
        "Scenes are equally hard if runs reach the same lines of the listing and the same cases, and each count "
        "differs "
        "by at most a tenth.\n"
        "If possible, all slopes and depths of a run are short: fractions of whole numbers with "
        "at most two digits, such as -17/22.\n"
        "Example: vidno homework scene.json --count 30 --seed 7 -o homework\n"
        "Exit status 1: fewer scenes were found than requested.");
    command.callback([options, &status] { status = homework(*options); });
}

}  // namespace

void add_homework(CLI::App& program, int& status) {
    const std::string does = "Make scenes with other numbers that are as hard as this one";
    describe_homework(*program.add_subcommand("homework", does), status);
    // Its former name is not in the help.
    describe_homework(*program.add_subcommand("variants", does)->group(""), status);
}

}  // namespace vidno::cli
