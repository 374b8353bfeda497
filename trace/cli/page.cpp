#include "page/page.h"

#include <filesystem>

#include "cli/commands.h"
#include "cli/shared/built_lesson.h"
#include "cli/shared/losses.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "cli/shared/trace_files.h"
#include "output.h"
#include "page/scorm.h"
#include "scene/failure.h"
#include "scene/scene_json.h"

namespace vidno::cli {

namespace {

struct PageOptions {
    std::vector<std::string> files;
    std::string output;
    Answers answers = Answers::included;
    std::optional<std::string> language;
    std::optional<int> questions;
};

constexpr int usual_questions = 5;  // each lesson of the course has a run with as many

std::string base_name(const std::string& file) { return std::filesystem::path(file).filename().string(); }

std::string title_of(const std::string& name, const std::string& file) { return name.empty() ? base_name(file) : name; }

std::string_view method_for(const Scene&) { return method_names[std::size_t(method_of(RunOptions{}))]; }
std::string_view method_for(const Surface&) { return floating_horizon_method; }
std::string text_of(const Scene& scene) { return scene_json(scene); }
std::string text_of(const Surface& surface) { return surface_json(surface); }

/// A failure, unchanged: the page runs it as it fails, goes to its step, and says what can be seen.
PageFile failure_file(const std::string& text, const std::string& file) {
    const Failure failure = read_failure(text, file);
    say(failure, file);
    const auto& [method, kernel, edition] = failure.fails;
    return {failure.title.english, method, kernel.name(), name_of(edition), RunOptions{}.detail, text, true};
}

/// A scene as admitted, or a surface with its samples, to be run with the defaults.
PageFile scene_file(const std::string& file) {
    const std::string text = read_text(file);
    if (is_failure(text)) return failure_file(text, file);
    const AnyScene any = any_scene_from(file);
    const auto made = [&](const auto& scene) -> PageFile {
        const RunOptions run;
        const std::string method(method_for(scene));
        return {title_of(name_of(any), file),
                method,
                run.kernel_name(),
                run.edition_name(),
                run.detail,
                text_of(scene),
                true};
    };
    return std::visit(made, any);
}

std::string_view method_in(const TraceHeader& header) { return method_names[std::size_t(header.method)]; }
std::string_view method_in(const FloatingHorizonHeader&) { return floating_horizon_method; }

/// A trace, once every event could be read.
PageFile trace_file(const std::string& file, Losses& losses) {
    Progress progress("events");
    const auto read = [&](auto& reader) -> PageFile {
        while (reader.next()) progress.show(reader.events());
        progress.clear();
        losses.add(reader);
        const auto& header = reader.header();
        return {title_of(header.scene.name, file),
                std::string(method_in(header)),
                header.kernel,
                name_of(header.edition),
                std::string(detail_names[std::size_t(header.detail)]),
                {},
                false};
    };
    AnyTraceReader reader = open_trace(LineReader(file), file);
    PageFile made = std::visit(read, reader);
    made.bytes = read_file(file);
    if (!made.bytes.starts_with("\x1f\x8b")) made.bytes = gzipped(made.bytes);
    return made;
}

/// False if the lesson has errors, which are printed.
bool add_lesson_to(PageContent& content, const std::string& folder, Answers answers) {
    Problems problems;
    const BuiltLesson built = built_lesson(folder, answers, problems);
    for (const auto& [file, text] : built.traces) content.files.emplace_back(file, gzipped(text));
    content.files.emplace_back(built.story_name, gzipped(built.story));
    content.index.push_back(built.entry);
    return status_after(problems) == 0;
}

int page(const PageOptions& options) {
    const bool is_package = options.output.ends_with(".zip");
    if (!is_package && options.output != "-" && !options.output.ends_with(".html"))
        throw Refused(options.output + ": not .html or .zip");
    if (options.questions && !is_package) throw Refused("--questions is for a package, which is .zip");
    std::optional<Language> language;
    if (options.language) language = Language(place_in(language_codes, *options.language));
    trace_page({});  // refuses what would be missing in the end before the work
    OutputFile output(options.output);
    bool lessons_are_right = true;
    Losses losses;
    PageContent content;
    for (const auto& file : options.files) {
        if (std::filesystem::is_directory(file)) {
            lessons_are_right = add_lesson_to(content, file, options.answers) && lessons_are_right;
        } else {
            expect_no_mesh(file);
            content.add(is_trace(file) ? trace_file(file, losses) : scene_file(file));
        }
    }
    const std::string made = trace_page(content, language);
    const std::string title = content.title(language.value_or(Language::english));
    output.write(is_package ? scorm_package(made, title, options.questions.value_or(usual_questions)) : made);
    output.commit();
    return losses.report() != 0 || !lessons_are_right ? 1 : 0;
}

}  // namespace

void add_page(CLI::App& program, int& status) {
    auto& command = *program.add_subcommand("page", "Make one page of traces and scenes that opens from disk");
    const auto options = std::make_shared<PageOptions>();
    command.add_option(
        "SCENE|TRACE", options->files,
        "Scene files, failures, traces (.jsonl, .jsonl.gz) and folders of lessons; without any, the page has the "
        "lessons of the course");
    command
        .add_option("-o", options->output,
                    "The page, .html, or - for standard output; or a SCORM 1.2 package of it for a learning management "
                    "system, .zip")
        ->required();
    command
        .add_option("--language", options->language,
                    "The language in which the page opens, and of the package's title [the browser's; en]")
        ->check(CLI::IsMember(words(language_codes)));
    command
        .add_option(
            "--questions", options->questions,
            "For .zip: how many questions must be answered to complete it [" + std::to_string(usual_questions) + "]")
        ->check(CLI::Range(1, 9999));
    add_no_answers(command, options->answers);
    command.footer(
        "The page contains everything that it shows and opens the first file; it runs scenes itself.\n"
        "Examples: vidno page run.jsonl.gz scene.json -o lecture.html\n"
        "          vidno page lessons/02-corner-depths --questions 8 -o corner-depths.zip\n"
        "Exit status 1: a trace was cut short, is partial, or its run lost something; the page contains what exists.");
    command.callback([options, &status] { status = page(*options); });
}

}  // namespace vidno::cli
