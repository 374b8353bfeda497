#include "homework/exercises.h"

#include <filesystem>
#include <iostream>

#include "commands.h"
#include "output.h"
#include "progress.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

/// From 01: as many digits as the last one has, so that names sort as numbers.
std::string number_of(std::size_t place, std::size_t count) {
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(count).size());
    const std::string number = std::to_string(place + 1);
    return std::string(digits - number.size(), '0') + number;
}

}  // namespace

int homework(const HomeworkOptions& options) {
    const std::filesystem::path folder(options.output);
    if (std::filesystem::exists(folder)) throw Refused(options.output + ": is there already");
    const Scene scene = scene_from(options.scene);
    expect_by_hand(scene, options.scene);
    Progress progress("exercises");
    auto found = exercises_of(scene, Method(place_in(method_names, options.method)), options.count, options.seed,
                              [&](std::size_t so_far) { progress.show(so_far, options.count); });
    progress.clear();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Refused(options.output + ": cannot be made: " + error.message());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::string number = number_of(i, options.count);
        found[i].name += (scene.name.empty() ? "" : " · ") + number;
        write_file(folder / (number + ".json"), scene_json(found[i]) + '\n');
    }
    if (found.size() == options.count) return 0;
    std::cerr << options.output << ": " << found.size() << " of " << options.count
              << " exercises: no more were found (another --seed may find more)\n";
    return 1;
}

}  // namespace vidno::cli
