#include "grade/grade.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <thread>

#include "characters.h"
#include "cli/commands.h"
#include "cli/shared/processes.h"
#include "cli/shared/progress.h"
#include "cli/shared/run_options.h"
#include "cli/shared/scene_files.h"
#include "cli/shared/shard.h"
#include "cli/shared/trace_files.h"
#include "grade/report.h"
#include "grade/scenes.h"
#include "grade/table.h"
#include "output.h"
#include "page/page.h"
#include "run/write_trace.h"
#include "scene/exact_scene.h"

namespace vidno::cli {

namespace {

/// What a student hands in.
enum class HandedIn : unsigned char { program, trace, folder };

struct GradeOptions {
    std::string program, output;      // or a trace, or a folder; the output may be empty
    std::vector<std::string> merged;  // tables, instead of a program
    std::vector<std::string> scenes;  // none: those of the program
    int seconds = 10, memory = 512, written = 64, processes = 64;
    int random = 8;
    unsigned seed = 1;
    std::size_t jobs = std::max(1U, std::thread::hardware_concurrency());
    std::string shard = "1/1";
    std::string detail{detail_names[0]}, language{language_codes[0]};
    bool no_sandbox = false, first = false;

    Language spoken() const { return Language(place_in(language_codes, language)); }

    HandedIn handed_in() const {
        if (std::filesystem::is_directory(program)) return HandedIn::folder;
        return is_trace(program) ? HandedIn::trace : HandedIn::program;
    }
};

PageFile page_file(const std::string& title, const AnyHeader& any, const std::string& trace) {
    return std::visit(
        [&](const auto& header) {
            return PageFile{title,
                            std::string(method_of(any)),
                            header.kernel,
                            name_of(header.edition),
                            std::string(detail_names[std::size_t(header.detail)]),
                            gzipped(trace),
                            false};
        },
        any);
}

/// The trace of the right run of the scene that the program drew, by the same method.
std::string right_trace(const TraceHeader& header, const NamedKernel& kernel) {
    std::string text;
    TraceWriter writer(header, [&](std::string_view part) { text += part; });
    const AdmittedScene scene = exact_scene::admit(header.scene);
    write_trace({header.method, kernel, header.edition, scene, header.detail}, writer);
    return text;
}

std::string right_trace(const FloatingHorizonHeader& header, const NamedKernel& kernel) {
    std::string text;
    TraceWriter writer(header, [&](std::string_view part) { text += part; });
    write_trace(FloatingHorizonRequest{kernel, header.edition, header.scene.curves, header.detail}, writer);
    return text;
}

PageFile right_run(AnyHeader any, const Words& say) {
    const NamedKernel kernel = kernel_of(KernelKind::filtered);
    const std::string text = std::visit(
        [&](auto& header) {
            header.edition = Edition::corrected;
            header.kernel = kernel.name();
            header.detail = Detail::signs;
            return right_trace(header, kernel);
        },
        any);
    return page_file(say({"Right", "Верно"}), any, text);
}

/// The page of a run beside the right one.
std::string page_of(const SceneGrade& grade, const Words& say) {
    PageContent content;
    content.add(page_file(say({"Your program: {}", "Ваша программа: {}"}, name_of(grade.scene)), *grade.run.header,
                          grade.run.trace));
    content.add(right_run(*grade.run.header, say));
    return trace_page(content);
}

/// Writes a file, or replaces a regular one. A pipe in its place would wait for a reader, a device would take it.
void write_new(const std::string& file, const std::string& text) {
    const auto status = std::filesystem::symlink_status(file);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw Refused(file + ": not a regular file, so the report is not written");
    write_file(file, text);
}

/// Writes the page and prints its address, at the wrong step.
void write_page(const SceneGrade& grade, const std::string& file, const Words& say) {
    if (!grade.run.header) throw Refused(file + ": there is no trace to show");
    write_new(file, page_of(grade, say));
    const auto& judgement = grade.judgement;
    const std::uint64_t step = judgement && judgement->wrong ? judgement->wrong->step : grade.run.events.size();
    std::cout << say({"\nThe program's run beside the right one, at that step:\n  ",
                      "\nРабота программы рядом с верной, на этом шаге:\n  "})
              << file_address(std::filesystem::absolute(file)) << "#trace=1&with=2&step=" << step << '\n';
}

bool adds_random_scenes(const GradeOptions& options) { return options.scenes.empty() && options.random > 0; }

/// A report must name each scene: one without a name gets that of its file.
AdmittedScene named(AdmittedScene scene, const std::string& file) {
    if (!scene->name.empty()) return scene;
    Scene with_name = scene;
    with_name.name = std::filesystem::path(file).stem().string();
    return exact_scene::admit(std::move(with_name));
}

ScenesToGrade scenes_of(const GradeOptions& options) {
    ScenesToGrade scenes;
    for (const auto& file : options.scenes) {
        AnyScene scene = any_scene_from(file);
        if (auto* surface = std::get_if<Surface>(&scene)) {
            scenes.surfaces.push_back(std::move(*surface));
        } else {
            scenes.polygons.push_back(named(std::get<AdmittedScene>(std::move(scene)), file));
        }
    }
    if (!options.scenes.empty()) return scenes;
    const Language language = options.spoken();
    scenes = {scenes_to_grade(language), surfaces_to_grade(language)};
    if (!adds_random_scenes(options)) return scenes;
    for (AdmittedScene& scene : random_scenes_to_grade(options.seed, options.random, language))
        scenes.polygons.push_back(std::move(scene));
    for (Surface& surface : random_surfaces_to_grade(options.seed, options.random, language))
        scenes.surfaces.push_back(std::move(surface));
    return scenes;
}

Grading grading_of(const GradeOptions& options) {
    Grading grading;
    grading.say = Words(options.spoken());
    grading.limits.time = std::chrono::seconds(options.seconds);
    grading.detail = Detail(std::find(detail_names.begin(), detail_names.end(), options.detail) - detail_names.begin());
    grading.first_only = options.first;
    grading.limits.memory = std::uint64_t(options.memory) << 20;
    grading.limits.written = std::uint64_t(options.written) << 20;
    grading.limits.processes = options.processes;
    if (options.handed_in() == HandedIn::trace) return grading;
    const Sandbox sandbox = options.no_sandbox ? Sandbox{} : find_sandbox();
    grading.limits.bubblewrap = sandbox.bubblewrap;
    if (!sandbox.missing.empty()) {
        std::cerr << grading.say({"No sandbox: {}. The program can read your files and reach the network.\n",
                                  "Песочницы нет: {}. Программе доступны ваши файлы и сеть.\n"},
                                 escaped_for_terminal(sandbox.missing));
    }
    const auto [guarantees, system_limits] = lacking_for(grading.limits, grading.say);
    if (!guarantees.empty())
        std::cerr << grading.say({"Not guaranteed here: {}.\n", "Здесь не обеспечивается: {}.\n"}, guarantees);
    if (!system_limits.empty()) {
        std::cerr << grading.say({"The system does not limit here, so it is counted every 10 to 100 ms: {}.\n",
                                  "Система здесь не ограничивает, поэтому каждые 10–100 мс подсчитывается: {}.\n"},
                                 system_limits);
    }
    return grading;
}

/// Why a program cannot be graded, since it never reports anything that can be judged; empty if it can.
std::string mute(const ProgramGrade& grade) {
    const auto is_mute = [](const SceneGrade& each) {
        return !each.judgement && each.run.ended.ending == Ending::done;
    };
    return std::all_of(grade.scenes.begin(), grade.scenes.end(), is_mute) ? grade.scenes.front().not_judged : "";
}

/// For a program that can be run again.
SceneGrade smallest_of(const std::string& program, const ProgramGrade& grade, const Grading& grading,
                       const Patience& patience) {
    Progress progress("scenes tried");
    return smallest_failing(program, *grade.first_wrong(), grade.precision, grading, patience,
                            [&, runs = 0ULL]() mutable { progress.show(++runs); });
}

/// Prints the seed, which reproduces the random scenes.
void print_seed(const GradeOptions& options, const Words& say) {
    if (!adds_random_scenes(options)) return;
    std::cout << say({"{} random scenes from the seed {}.\n", "Случайных сцен {}, начальное число {}.\n"},
                     options.random, std::to_string(options.seed));
}

int grade_one(const GradeOptions& options, const Grading& grading) {
    const Words& say = grading.say;
    const bool can_run = options.handed_in() == HandedIn::program;
    ProgramGrade grade;
    if (!can_run) {
        if (!std::filesystem::is_regular_file(options.program) && std::filesystem::exists(options.program))
            throw Refused(options.program + ": not a regular file");
        LineReader lines(options.program);
        std::string text;
        for (std::string line; lines.next(line);) text += lines.cut() ? line : line + '\n';
        grade = grade_trace(std::move(text), grading);
    } else {
        const ScenesToGrade scenes = scenes_of(options);
        Progress progress("scenes");
        grade = grade_program(options.program, scenes, grading, [&](std::size_t done) { progress.show(done); });
    }
    if (const std::string reason = mute(grade); !reason.empty()) throw Refused(options.program + ": " + reason);
    std::cout << report_of(grade, grading);
    if (can_run && adds_random_scenes(options)) std::cout << '\n';
    if (can_run) print_seed(options, say);
    if (grade.wrong() == 0) return grade.right() ? 0 : 1;
    SceneGrade shown = *grade.first_wrong();
    if (can_run && !options.first && shown.run.header) {
        shown = smallest_of(options.program, grade, grading, {});
        std::cout << report_of_smallest(shown, grading);
    }
    if (!options.output.empty()) write_page(shown, options.output, say);
    return 1;
}

/// What a folder has for the table: a program, or something that is refused.
struct Entry {
    std::filesystem::path file;
    std::string refused;  // why; empty for a program
};

std::string kind_of(std::filesystem::file_type type) {
    using Type = std::filesystem::file_type;
    switch (type) {
        case Type::symlink: return "a symbolic link";
        case Type::fifo: return "a pipe";
        case Type::socket: return "a socket";
        case Type::block:
        case Type::character: return "a device";
        default: return "no file";
    }
}

/// The programs in a folder, by their names. Sources and folders are passed over. A link could lead to another
/// student's program.
std::vector<Entry> programs_in(const std::string& folder) {
    std::vector<Entry> programs;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const auto status = entry.symlink_status();
        const auto executable = std::filesystem::perms::owner_exec;
        if (std::filesystem::is_directory(status)) continue;
        if (!std::filesystem::is_regular_file(status)) {
            programs.push_back({entry.path(), kind_of(status.type()) + ": only regular files are graded"});
        } else if ((status.permissions() & executable) != std::filesystem::perms::none) {
            programs.push_back({entry.path(), {}});
        }
    }
    std::sort(programs.begin(), programs.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
    if (programs.empty()) throw Refused(folder + ": contains no programs");
    return programs;
}

bool page_is_built() {
    try {
        trace_page({});
        return true;
    } catch (const Refused&) {
        return false;
    }
}

/// Exit status 0 if every program is right.
int write_table(std::vector<TableLine> lines, const std::string& file) {
    const bool all_right = std::ranges::all_of(lines, &TableLine::is_right);
    write_new(file, table_of(std::move(lines), *table_format_of(file)));
    return all_right ? 0 : 1;
}

/// What a folder's programs are graded on, and where their reports go.
struct FolderGrading {
    const Grading& grading;
    ScenesToGrade scenes;
    std::filesystem::path reports;
    TableFormat format;
    bool has_page;
};

/// The grade of a program, and the sentence on it that is printed.
struct Graded {
    TableLine line;
    std::string said;
};

/// Grades a program and writes its report, and a page if it is wrong and the page was built.
Graded grade_entry(const Entry& entry, const FolderGrading& of) {
    const Grading& grading = of.grading;
    const std::string name = escaped_for_terminal(entry.file.filename().string());
    const std::string report = (of.reports / entry.file.filename()).string();
    const auto not_judged = [&](const std::string& why) {
        const std::string reason = escaped_for_terminal(why);
        write_new(report + ".txt", reason + '\n');
        return Graded{line_of(name, reason, of.format), reason};
    };
    if (!entry.refused.empty()) return not_judged(entry.refused);
    try {
        const ProgramGrade grade = grade_program(entry.file, of.scenes, grading, [](std::size_t) {});
        if (const std::string reason = mute(grade); !reason.empty()) return not_judged(reason);
        std::string text = report_of(grade, grading);
        const SceneGrade* first = grade.first_wrong();
        if (first && first->run.header) {
            const Patience patience{100, std::chrono::seconds(5)};
            const SceneGrade smallest = smallest_of(entry.file.string(), grade, grading, patience);
            text += report_of_smallest(smallest, grading);
            if (of.has_page) write_new(report + ".html", page_of(smallest, grading.say));
        }
        write_new(report + ".txt", text);
        return {line_of(name, grade, of.format, grading.say),
                grade.right() ? grading.say({"right", "верно"})
                              : grading.say({"wrong on {} of {}", "неверно на сценах: {} из {}"}, grade.wrong(),
                                            grade.scenes.size())};
    } catch (const Refused& refused) {
        return not_judged(refused.what());
    }
}

/// Writes a report of each program into the folder named like the table without its extension.
int grade_folder(const GradeOptions& options, const Grading& grading) {
    std::vector<Entry> programs = programs_in(options.program);
    const auto [number, shards] = shard_from(options.shard);
    std::vector<Entry> own;
    for (std::size_t i = number - 1; i < programs.size(); i += shards) own.push_back(std::move(programs[i]));
    const FolderGrading of{grading, scenes_of(options), std::filesystem::path(options.output).replace_extension(),
                           *table_format_of(options.output), page_is_built()};
    std::filesystem::create_directories(of.reports);
    print_seed(options, grading.say);
    std::vector<TableLine> lines;
    in_processes(
        options.jobs, own.size(),
        [&](std::size_t i) {
            const Graded graded = grade_entry(own[i], of);
            return Parts{graded.line.program, graded.line.text, graded.line.is_right ? "right" : "wrong", graded.said};
        },
        [&](Parts parts) {
            std::cout << "  " << parts[0] << ": " << parts[3] << std::endl;
            lines.push_back({std::move(parts[0]), std::move(parts[1]), parts[2] == "right"});
        });
    return write_table(std::move(lines), options.output);
}

int merge_tables(const GradeOptions& options) {
    std::vector<TableLine> lines;
    for (const std::string& file : options.merged) {
        const auto format = table_format_of(file);
        if (format != table_format_of(options.output)) throw Refused(file + ": not a table of the format of -o");
        std::ranges::move(lines_of(read_text(file), *format, file), std::back_inserter(lines));
    }
    return write_table(std::move(lines), options.output);
}

int grade(const GradeOptions& options) {
    if (options.merged.empty() && options.program.empty())
        throw Refused("name a program, a trace or a folder, or tables to --merge");
    const bool is_folder = options.merged.empty() && options.handed_in() == HandedIn::folder;
    if ((is_folder || !options.merged.empty()) && !table_format_of(options.output))
        throw Refused((is_folder ? options.program + " is a folder, so -o" : "--merge: -o") +
                      " must name a table, .csv or .json");
    if (!options.merged.empty()) return merge_tables(options);
    if (!is_folder && !options.output.empty() && !options.output.ends_with(".html"))
        throw Refused(options.output + ": not .html");
    if (!is_folder && !options.output.empty())
        trace_page({});  // refuses what would be missing in the end before the work
    const Grading grading = grading_of(options);
    return is_folder ? grade_folder(options, grading) : grade_one(options, grading);
}

}  // namespace

void add_grade(CLI::App& program, int& status) {
    auto& command =
        *program.add_subcommand("grade", "Check each step of a student's program, or of its trace, for correctness");
    const auto options = std::make_shared<GradeOptions>();
    auto* program_option = command.add_option(
        "PROGRAM|TRACE|FOLDER", options->program,
        "A program that writes a trace with lessons/student/vidno_student.h, such a trace (.jsonl, .jsonl.gz), "
        "or a folder of such programs");
    auto* jobs =
        command
            .add_option("--jobs", options->jobs, "How many programs of a folder to grade at a time [one for each core]")
            ->check(CLI::Range(1, 1024));
    auto* shard = command.add_option(
        "--shard", options->shard,
        "K/N: of a folder grade only every N-th program, from the K-th; auto: as the task of an array "
        "of Slurm says");
    auto* merge = command.add_option("--merge", options->merged, "Merge the tables of shards into the table of -o");
    for (auto* of_run : {jobs, shard, program_option}) merge->excludes(of_run);
    command.add_option("--scenes", options->scenes, "Scene or surface files to run it on [a set of small ones]");
    command.add_option("--random", options->random, "The number of random scenes to add to that set")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command.add_option("--seed", options->seed, "The seed of the random scenes")->capture_default_str();
    command
        .add_option("--detail", options->detail,
                    "The trace must contain every claim of this level; otherwise the exit status is 1")
        ->check(CLI::IsMember(words(detail_names)))
        ->capture_default_str();
    command.add_option("--seconds", options->seconds, "The time limit for a run")
        ->check(CLI::Range(1, 3600))
        ->capture_default_str();
    command.add_option("--memory", options->memory, "The MiB of memory for the processes of a run together")
        ->check(CLI::Range(16, 1 << 20))
        ->capture_default_str();
    command.add_option("--written", options->written, "The MiB that a run may write and print")
        ->check(CLI::Range(1, 1 << 16))
        ->capture_default_str();
    command.add_option("--processes", options->processes, "How many processes and threads a run may have at once")
        ->check(CLI::Range(1, 1 << 16))
        ->capture_default_str();
    command.add_flag("--first", options->first,
                     "Stop at the first scene that goes wrong, without a search for a smaller one");
    command.add_flag("--no-sandbox", options->no_sandbox,
                     "Run the program with access to your files and to the network");
    command.add_option("--language", options->language, "The language of the report")
        ->check(CLI::IsMember(words(language_codes)))
        ->capture_default_str();
    command.add_option("-o", options->output,
                       "A page, .html, with the wrong run on the smallest scene beside the right one; for a folder a "
                       "table, .csv or .json, with a report on each program in a folder of the same name");
    command.footer(
        "It judges Warnock's algorithm, the Z-buffer, Weiler and Atherton's algorithm and the floating horizon.\n"
        "A different order, a different rule for outlines, recursion and float are accepted. Steps that a program\n"
        "does not report are not judged; the report lists what was reported. Programs run with limits and, where\n"
        "bubblewrap can create a sandbox, without network and without access to your files. What cannot be guaranteed\n"
        "is said before any program runs; docs/grading.md has the details.\n"
        "Example: vidno grade ./warnock -o report.html\n"
        "Example: vidno grade homework/ --detail polygons -o table.csv\n"
        "Example: vidno grade homework/ --shard 1/2 -o 1.csv; vidno grade --merge 1.csv 2.csv -o table.csv\n"
        "Exit status 1: something is wrong, or a required claim is missing.");
    command.callback([options, &status] { status = grade(*options); });
}

}  // namespace vidno::cli
