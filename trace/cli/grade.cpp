#include "grade/grade.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>

#include "cli/commands.h"
#include "cli/shared/progress.h"
#include "cli/shared/scene_files.h"
#include "cli/shared/trace_files.h"
#include "grade/scenes.h"
#include "output.h"
#include "page/page.h"
#include "run/write_trace.h"

namespace vidno::cli {

namespace {

struct GradeOptions {
    std::string program, output;      // or a trace; the output may be empty
    std::vector<std::string> scenes;  // none: those of the program
    int seconds = 10;
};

/// A program that did not end so often is not waited for any more.
constexpr int enough_endless = 2;

std::string quoted(const Scene& scene) { return '"' + (scene.name.empty() ? "a scene" : scene.name) + '"'; }

std::string place_of(const Wrong& wrong) {
    return "step " + std::to_string(wrong.step) + (wrong.at.empty() ? "" : ", " + wrong.at);
}

void print_line(const SceneGrade& grade, const Limits& limits) {
    const auto line = [&](const char* verdict, const std::string& more) {
        std::cout << "  " << std::left << std::setw(11) << verdict << grade.scene.name << (more.empty() ? "" : ": ")
                  << more << '\n';
    };
    if (!grade.judgement) return line("not judged", grade.not_judged);
    const std::string ended = grade.run.ended.ending == Ending::done ? "" : words_of(grade.run.ended, limits);
    if (grade.judgement->wrong) {
        return line("wrong", place_of(*grade.judgement->wrong) + (ended.empty() ? "" : "; ") + ended);
    }
    if (!ended.empty()) return line("wrong", ended);
    if (!grade.run.unreadable.empty()) return line("wrong", grade.run.unreadable);
    if (!grade.run.complete) return line("wrong", "the trace is cut short");
    line("right", "");
}

/// What is different from our procedures and as right.
void print_differences(const std::vector<SceneGrade>& grades) {
    std::map<Difference, int> scenes;
    for (const auto& grade : grades) {
        if (!grade.judgement) continue;
        for (const Difference each : grade.judgement->differences) ++scenes[each];
    }
    if (!scenes.empty()) std::cout << "\nDifferent, and as right:\n";
    for (const auto& [difference, count] : scenes) {
        std::cout << "  " << words_of(difference) << " (" << count << (count == 1 ? " scene" : " scenes") << ")\n";
    }
}

/// What the program printed, indented; the first lines of it.
void print_said(const std::string& said) {
    std::size_t begin = 0;
    for (int lines = 0; lines < 5 && begin < said.size(); ++lines) {
        const std::size_t end = std::min(said.find('\n', begin), said.size());
        std::cout << "    | " << said.substr(begin, end - begin) << '\n';
        begin = end + 1;
    }
}

void print_failure(const SceneGrade& grade, const Limits& limits) {
    const StudentRun& run = grade.run;
    if (run.ended.ending != Ending::done) {
        std::cout << "  The program " << words_of(run.ended, limits);
        if (const auto cause = cause_of(run.ended); !cause.empty()) std::cout << ": " << cause;
        if (run.header) std::cout << ". The trace ends after step " << run.events.size();
        std::cout << ".\n";
    }
    if (!grade.judgement) std::cout << "  Not judged: " << grade.not_judged << ".\n";
    if (grade.judgement && grade.judgement->wrong) {
        const Wrong& wrong = *grade.judgement->wrong;
        std::cout << "  " << place_of(wrong) << '\n'
                  << "    the program: " << wrong.told << '\n'
                  << "    but:         " << wrong.right << '\n';
    }
    print_said(run.ended.said);
}

void print_polygons(const Scene& scene) {
    const Area& area = scene.area;
    std::cout << "  area (" << area.x << ", " << area.y << ") of " << area.width << " x " << area.height << '\n';
    for (const auto& polygon : scene.polygons) {
        std::cout << "  " << polygon.id;
        for (const auto& v : polygon.vertices) {
            std::cout << " (" << in_words(v.x) << ", " << in_words(v.y) << ", " << in_words(v.z) << ')';
        }
        std::cout << '\n';
    }
}

PageFile page_file(const std::string& title, const TraceHeader& header, const std::string& trace) {
    return {title,
            std::string(method_names[std::size_t(header.method)]),
            header.kernel,
            name_of(header.edition),
            std::string(detail_names[std::size_t(header.detail)]),
            gzipped(trace),
            false};
}

/// The right run of the scene that the program drew, by the same method.
PageFile right_run(const TraceHeader& drawn) {
    const NamedKernel kernel = *kernel_named("filtered");
    const TraceHeader header{drawn.method, Edition::corrected, kernel.name(), Detail::signs, drawn.scene};
    std::string text;
    TraceWriter writer(header, [&](std::string_view part) { text += part; });
    write_trace({drawn.method, kernel, Edition::corrected, drawn.scene, Detail::signs}, writer);
    return page_file("Right", header, text);
}

/// Writes the page and says its address, at the wrong step.
void write_page(const SceneGrade& grade, const std::string& file) {
    if (!grade.run.header) throw Refused(file + ": there is no trace to be shown");
    PageContent content;
    content.add(page_file("Your program: " + grade.scene.name, *grade.run.header, grade.run.trace));
    content.add(right_run(*grade.run.header));
    OutputFile output(file);
    output.write(trace_page(content));
    output.commit();
    const auto& judgement = grade.judgement;
    const std::uint64_t step = judgement && judgement->wrong ? judgement->wrong->step : grade.run.events.size();
    std::cout << "\nThe program's run beside the right one, at that step:\n  "
              << file_address(std::filesystem::absolute(file)) << "#trace=1&with=2&step=" << step << '\n';
}

std::vector<Scene> scenes_of(const GradeOptions& options) {
    if (options.scenes.empty()) return scenes_to_grade();
    std::vector<Scene> scenes;
    for (const auto& file : options.scenes) scenes.push_back(scene_from(file));
    return scenes;
}

std::vector<SceneGrade> grades_of(const GradeOptions& options, const Limits& limits) {
    std::vector<SceneGrade> grades;
    if (is_trace(options.program)) {
        LineReader lines(options.program);
        std::string text;
        for (std::string line; lines.next(line);) text += line + '\n';
        grades.push_back(grade_trace(std::move(text)));
        return grades;
    }
    Progress progress("scenes");
    const std::vector<Scene> scenes = scenes_of(options);
    int endless = 0;
    for (const Scene& scene : scenes) {
        progress.show(grades.size());
        grades.push_back(grade_scene(options.program, scene, limits));
        if (grades.back().run.ended.ending == Ending::out_of_time && ++endless == enough_endless) break;
    }
    progress.clear();
    if (grades.size() < scenes.size())
        std::cout << "  Not run on the " << scenes.size() - grades.size() << " scenes after these.\n";
    return grades;
}

/// A program that never tells anything that can be judged is none to be graded.
void expect_judged(const std::vector<SceneGrade>& grades, const std::string& program) {
    const auto is_mute = [](const SceneGrade& grade) {
        return !grade.judgement && grade.run.ended.ending == Ending::done;
    };
    if (std::all_of(grades.begin(), grades.end(), is_mute)) throw Refused(program + ": " + grades.front().not_judged);
}

/// Of the failures that say what is wrong the first; else the first of all.
const SceneGrade& telling(const std::vector<SceneGrade>& grades) {
    const auto tells = [](const SceneGrade& grade) { return grade.judgement && grade.judgement->wrong; };
    const auto told = std::find_if(grades.begin(), grades.end(), tells);
    if (told != grades.end()) return *told;
    return *std::find_if(grades.begin(), grades.end(), [](const auto& grade) { return !grade.right(); });
}

int grade(const GradeOptions& options) {
    if (!options.output.empty()) {
        if (!options.output.ends_with(".html")) throw Refused(options.output + ": not .html");
        trace_page({});  // refuses what would be missing in the end before the work
    }
    Limits limits;
    limits.time = std::chrono::seconds(options.seconds);
    const std::vector<SceneGrade> grades = grades_of(options, limits);
    expect_judged(grades, options.program);
    for (const auto& each : grades) print_line(each, limits);
    print_differences(grades);
    const auto wrong = std::count_if(grades.begin(), grades.end(), [](const auto& each) { return !each.right(); });
    if (wrong == 0) {
        std::cout << "\nRight" << (grades.size() > 1 ? " on all " + std::to_string(grades.size()) + " scenes" : "")
                  << ".\n";
        return 0;
    }
    const SceneGrade& first = telling(grades);
    std::cout << "\nWrong on " << wrong << " of " << grades.size() << ", first on " << quoted(first.scene) << ":\n";
    print_failure(first, limits);
    if (const auto mistake = usual_mistake(grades)) {
        std::cout << "\nIt behaves like a usual mistake, " << name_of(*mistake) << ": "
                  << choice_of(*single_deviation(*mistake)).advice << ".\n";
    }
    if (is_trace(options.program) || !first.run.header) {
        if (!options.output.empty()) write_page(first, options.output);
        return 1;
    }
    Progress progress("scenes tried");
    const SceneGrade smallest =
        smallest_failing(options.program, first, limits, {}, [&, runs = 0ULL]() mutable { progress.show(++runs); });
    progress.clear();
    std::cout << "\nThe smallest scene that shows it:\n";
    print_polygons(smallest.scene);
    print_failure(smallest, limits);
    if (!options.output.empty()) write_page(smallest, options.output);
    return 1;
}

}  // namespace

void add_grade(CLI::App& program, int& status) {
    auto& command =
        *program.add_subcommand("grade", "Judge a student's program, or its trace, by the meaning of each step");
    const auto options = std::make_shared<GradeOptions>();
    command
        .add_option(
            "PROGRAM|TRACE", options->program,
            "A program that writes a trace by lessons/student/vidno_student.h, or such a trace (.jsonl, .jsonl.gz)")
        ->required();
    command.add_option("--scenes", options->scenes, "Scene files to run it on; without them, on a set of small ones");
    command.add_option("--seconds", options->seconds, "How long a run may take")
        ->check(CLI::Range(1, 3600))
        ->capture_default_str();
    command.add_option("-o", options->output,
                       "A page, .html, with the wrong run on the smallest scene beside the right one");
    command.footer(
        "Another order, another rule for outlines, recursion and float are as right. The program is run with limits "
        "of\n"
        "time, memory and output, which guard against mistakes, not against malice.\n"
        "Example: vidno grade ./warnock -o report.html\n"
        "Exit status 1: something is wrong.");
    command.callback([options, &status] { status = grade(*options); });
}

}  // namespace vidno::cli
