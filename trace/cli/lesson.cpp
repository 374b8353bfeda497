#include "lesson/lesson.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cli/commands.h"
#include "cli/shared/built_lesson.h"
#include "cli/shared/losses.h"
#include "cli/shared/scene_files.h"
#include "import/import.h"
#include "import/mesh_soup.h"
#include "lesson/new_lesson.h"
#include "output.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

struct LessonOptions {
    std::vector<std::string> folders;
    std::string source, output;  // of a new one: a scene or a mesh; the folder
    std::string run;             // of a pin: the run's name, empty for the first
    std::uint64_t step = 0;
    Answers answers = Answers::included;
};

/// Removes a course that was built here before.
void remove_course(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".jsonl.gz") || name.ends_with(".lesson.json")) std::filesystem::remove(entry.path());
    }
}

int check_lessons(const LessonOptions& options) {
    Problems problems;
    for (const auto& folder : options.folders) {
        const Lesson lesson = read_lesson(folder, problems);
        check_lesson(lesson, problems);
        if (!lesson.runs.empty()) run_lesson(lesson, problems);
        check_figures(lesson, problems);
    }
    return status_after(problems);
}

int build_course(const LessonOptions& options) {
    const std::filesystem::path folder(options.output);
    std::filesystem::create_directories(folder);
    remove_course(folder);
    Problems problems;
    auto index = nlohmann::ordered_json::array();
    for (const auto& name : options.folders) {
        const BuiltLesson lesson = built_lesson(name, options.answers, problems);
        for (const auto& [file, text] : lesson.traces) write_file(folder / file, gzipped(text), Packing::done);
        write_file(folder / lesson.story_name, lesson.story + '\n');
        index.push_back(lesson.entry);
        std::cerr << "  " << name << '\n';
    }
    write_file(folder / "index.json", index.dump(1) + '\n');
    return status_after(problems);
}

int make_lesson(const LessonOptions& options) {
    const std::filesystem::path folder(options.output);
    if (std::filesystem::exists(folder)) throw Refused(options.output + " already exists");
    const bool is_mesh = !options.source.ends_with(".json");
    Losses losses;
    const auto imported = [&] {
        ImportedScene made = import_mesh_file(options.source, {});
        losses.add(options.source, made.losses);
        return AnyScene(std::move(made.scene));
    };
    const AnyScene scene = is_mesh ? imported() : any_scene_from(options.source);
    auto files = new_lesson(scene);
    files["scene.json"] = is_mesh ? scene_json(std::get<AdmittedScene>(scene)) + '\n' : read_text(options.source);
    std::filesystem::create_directories(folder);
    for (const auto& [name, text] : files) write_file(folder / name, text);
    std::cerr << options.output << ": write its stories where they say TODO, then vidno lesson check " << options.output
              << '\n';
    return losses.report();
}

int print_pin(const LessonOptions& options) {
    Problems problems;
    const Lesson lesson = read_lesson(options.folders.front(), problems);
    const auto run = std::find_if(lesson.runs.begin(), lesson.runs.end(), [&](const LessonRun& each) {
        return options.run.empty() || each.name == options.run;
    });
    if (run == lesson.runs.end()) throw Refused("--run " + options.run + ": " + lesson.folder + " has no such run");
    std::cout << pin_of_step(scene_of(lesson, *run), *run, options.step) << '\n';
    return 0;
}

}  // namespace

void add_lesson(CLI::App& program, int& status) {
    auto& command =
        *program.add_subcommand("lesson", "Write a lesson: make its files, pin its steps, check it, build the course");
    command.require_subcommand(0, 1);  // one; 0 so that a wrong name is reported before a missing one
    const auto options = std::make_shared<LessonOptions>();
    const auto add_folders = [&options](CLI::App& sub) {
        sub.add_option("FOLDER", options->folders, "Folders of lessons")->required();
    };

    auto& made = *command.add_subcommand("new", "Make the folder of a lesson from a scene or a mesh");
    made.add_option("SCENE|MESH", options->source, "A scene or surface file, or a mesh: " + mesh_endings())->required();
    made.add_option("-o", options->output, "The folder, which must not exist yet")->required();
    made.footer("Example: vidno lesson new scene.json -o lessons/11-my-topic");
    made.callback([options, &status] { status = make_lesson(*options); });

    auto& pin = *command.add_subcommand("pin", "Print the pin of a step, as a line for lesson.json");
    add_folders(pin);
    pin.add_option("--run", options->run, "The run [the first]");
    pin.add_option("--step", options->step, "The step, as the page counts them")->required();
    pin.callback([options, &status] { status = print_pin(*options); });

    auto& check = *command.add_subcommand("check", "Report errors in lessons, with file and line");
    add_folders(check);
    check.footer("Exit status 1: there are errors.");
    check.callback([options, &status] { status = check_lessons(*options); });

    auto& build = *command.add_subcommand("build", "Trace lessons and find their pins, for the page");
    add_folders(build);
    build.add_option("-o", options->output, "The folder of the course")->required();
    add_no_answers(build, options->answers);
    build.footer("Exit status 1: there are errors, which lesson check reports; the rest is built.");
    build.callback([options, &status] { status = build_course(*options); });
}

}  // namespace vidno::cli
