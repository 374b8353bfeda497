#include "cli/shared/built_lesson.h"

#include <iostream>
#include <map>

#include "cli/shared/drawn_figure.h"
#include "refused.h"

namespace vidno::cli {

namespace {

using Json = nlohmann::ordered_json;

/// The options of a figure's command. Its files are relative to the parent of the lessons' folder.
FigureOptions options_of(const std::string& command, const Lesson& lesson) {
    FigureOptions options = figure_options(command);
    if (!options.output.ends_with(".svg")) throw Refused(options.output + ": not .svg");
    const auto top = lesson.place.parent_path().parent_path();
    options.input = (top / options.input).string();
    return options;
}

Figures figures_of(const Lesson& lesson, Language language, Problems& problems) {
    Figures figures;
    const Story& story = lesson.stories.in(language);
    for (const auto& [line, command, file] : story.figures) {
        try {
            FigureOptions options = options_of(command, lesson);
            options.language = code_of(language);
            Losses shown;  // a lesson shows faults on purpose
            figures[file] = drawn_figure(options, shown);
        } catch (const Refused& refused) {
            problems.push_back({story.file, line, refused.what()});
        }
    }
    return figures;
}

/// The title of a run: the lesson's, or the name of its scene; never the name of a file.
Json title_of(const Lesson& lesson, const LessonRun& run) {
    if (!run.title.english.empty()) return object_of<Json>(run.title);
    std::string name = name_of(scene_of(lesson, run));
    return object_of<Json>(in_each_language([&](Language) { return name; }));
}

}  // namespace

BuiltLesson built_lesson(const std::string& folder, Answers answers, Problems& problems) {
    const Lesson lesson = read_lesson(folder, problems);
    check_lesson(lesson, problems);
    std::map<std::string, std::string> texts;  // of the traces, by their runs
    const Steps steps =
        run_lesson(lesson, problems, [&](const LessonRun& run, std::string_view text) { texts[run.name] += text; });
    const auto figures = in_each_language([&](Language language) { return figures_of(lesson, language, problems); });

    BuiltLesson made;
    made.story_name = lesson.id + ".lesson.json";
    made.story = lesson_json(lesson, steps, figures, answers);
    Json traces = Json::array();
    for (const auto& run : lesson.runs) {
        const std::string file = run.trace_file(lesson.id);
        made.traces.emplace_back(file, std::move(texts[run.name]));
        Json trace{{"file", file},
                   {"method", run.method},
                   {"kernel", run.kernel.name()},
                   {"edition", name_of(run.edition)},
                   {"detail", detail_names[std::size_t(run.detail)]}};
        const Json title = title_of(lesson, run);
        if (!title["en"].get_ref<const std::string&>().empty()) trace["title"] = title;
        traces.push_back(std::move(trace));
    }
    const auto titles = in_each_language([&](Language language) { return lesson.stories.in(language).plain_title; });
    made.entry = {{"id", lesson.id},
                  {"title", object_of<Json>(titles)},
                  {"traces", std::move(traces)},
                  {"story", made.story_name}};
    return made;
}

void add_no_answers(CLI::App& command, Answers& answers) {
    command.add_flag_callback(
        "--no-answers", [&answers] { answers = Answers::omitted; },
        "Omit the answers to the questions and exercises of lessons");
}

void check_figures(const Lesson& lesson, Problems& problems) {
    for (const Language language : languages) figures_of(lesson, language, problems);
}

int status_after(const Problems& problems) {
    for (const auto& problem : problems) std::cerr << problem.text() << '\n';
    return problems.empty() ? 0 : 1;
}

}  // namespace vidno::cli
