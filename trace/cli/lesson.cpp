#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "commands.h"
#include "import/import.h"
#include "lesson/lesson.h"
#include "lesson/new_lesson.h"
#include "output.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

using Json = nlohmann::ordered_json;

int told(const Problems& problems) {
    for (const auto& problem : problems) std::cerr << problem.text() << '\n';
    return problems.empty() ? 0 : 1;
}

/// Of a course that was built here before.
void remove_course(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(".jsonl.gz") || name.ends_with(".lesson.json")) std::filesystem::remove(entry.path());
    }
}

/// The options of a figure's command. Its files are named from the folder that has the lessons' folder in it.
FigureOptions options_of(const std::string& command, const Lesson& lesson) {
    FigureOptions options = figure_options(command);
    if (!options.output.ends_with(".svg")) throw Refused(options.output + ": not .svg");
    const auto top = lesson.place.parent_path().parent_path();
    options.input = (top / options.input).string();
    return options;
}

Figures figures_of(const Lesson& lesson, const Story& story, const std::string& language, Problems& problems) {
    Figures figures;
    for (const auto& [line, command, file] : story.figures) {
        try {
            FigureOptions options = options_of(command, lesson);
            options.language = language;
            figures[file] = drawn_figure(options);
        } catch (const Refused& refused) {
            problems.push_back({story.file, line, refused.what()});
        }
    }
    return figures;
}

/// What the index of a course says of a lesson, and the files that this names.
struct Built {
    Json entry;
    std::vector<std::pair<std::string, std::string>> traces;
    std::string story_name, story;
};

Built built(const std::string& folder, Problems& problems) {
    const Lesson lesson = read_lesson(folder, problems);
    check_lesson(lesson, problems);
    std::map<std::string, std::string> texts;  // of the traces, by their runs
    const Steps steps =
        run_lesson(lesson, problems, [&](const LessonRun& run, std::string_view text) { texts[run.name] += text; });
    const Figures in_english = figures_of(lesson, lesson.english, "en", problems);
    const Figures in_russian = figures_of(lesson, lesson.russian, "ru", problems);

    Built made;
    made.story_name = lesson.id + ".lesson.json";
    made.story = lesson_json(lesson, steps, in_english, in_russian);
    Json traces = Json::array();
    for (const auto& run : lesson.runs) {
        const std::string file = run.trace_file(lesson.id);
        made.traces.emplace_back(file, std::move(texts[run.name]));
        Json trace{{"file", file},
                   {"method", run.method},
                   {"kernel", run.kernel},
                   {"edition", edition_names[std::size_t(run.edition)]},
                   {"detail", detail_names[std::size_t(run.detail)]}};
        if (!run.other_scene().empty()) trace["scene"] = run.other_scene();
        traces.push_back(std::move(trace));
    }
    made.entry = {{"id", lesson.id},
                  {"title", {{"en", lesson.english.plain_title}, {"ru", lesson.russian.plain_title}}},
                  {"traces", std::move(traces)},
                  {"story", made.story_name}};
    return made;
}

}  // namespace

int lesson_check(const LessonOptions& options) {
    Problems problems;
    for (const auto& folder : options.folders) {
        const Lesson lesson = read_lesson(folder, problems);
        check_lesson(lesson, problems);
        if (!lesson.runs.empty()) run_lesson(lesson, problems);
        figures_of(lesson, lesson.english, "en", problems);
        figures_of(lesson, lesson.russian, "ru", problems);
    }
    return told(problems);
}

int lesson_build(const LessonOptions& options) {
    const std::filesystem::path folder(options.output);
    std::filesystem::create_directories(folder);
    remove_course(folder);
    Problems problems;
    Json index = Json::array();
    for (const auto& name : options.folders) {
        const Built lesson = built(name, problems);
        for (const auto& [file, text] : lesson.traces) write_file(folder / file, gzipped(text), Packing::done);
        write_file(folder / lesson.story_name, lesson.story + '\n');
        index.push_back(lesson.entry);
        std::cerr << "  " << name << '\n';
    }
    write_file(folder / "index.json", index.dump(1) + '\n');
    return told(problems);
}

bool add_lesson(const std::string& folder, PageContent& content) {
    Problems problems;
    const Built lesson = built(folder, problems);
    for (const auto& [file, text] : lesson.traces) content.files.emplace_back(file, gzipped(text));
    content.files.emplace_back(lesson.story_name, gzipped(lesson.story));
    content.index.push_back(lesson.entry);
    return told(problems) == 0;
}

int lesson_new(const LessonOptions& options) {
    const std::filesystem::path folder(options.output);
    if (std::filesystem::exists(folder)) throw Refused(options.output + ": is there already");
    const bool is_mesh = !options.source.ends_with(".json");
    const AnyScene scene = is_mesh ? AnyScene(import_mesh(read_file(options.source), options.source, {}).scene)
                                   : any_scene_from(options.source, std::nullopt);
    auto files = new_lesson(scene);
    files["scene.json"] = is_mesh ? scene_json(std::get<Scene>(scene)) + '\n' : read_file(options.source);
    std::filesystem::create_directories(folder);
    for (const auto& [name, text] : files) write_file(folder / name, text);
    std::cerr << options.output << ": write its stories where they say TODO, then vidno lesson check " << options.output
              << '\n';
    return 0;
}

int lesson_pin(const LessonOptions& options) {
    Problems problems;
    const Lesson lesson = read_lesson(options.folders.front(), problems);
    const auto run = std::find_if(lesson.runs.begin(), lesson.runs.end(), [&](const LessonRun& each) {
        return options.run.empty() || each.name == options.run;
    });
    if (run == lesson.runs.end()) throw Refused("--run " + options.run + ": " + lesson.folder + " has no such run");
    std::cout << pin_of_step(scene_of(lesson, *run), *run, options.step) << '\n';
    return 0;
}

}  // namespace vidno::cli
