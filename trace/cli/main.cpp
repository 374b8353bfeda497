/// The program vidno.

#include <CLI/CLI.hpp>
#include <iostream>

#include "chart/chart.h"
#include "choice/method.h"
#include "commands.h"
#include "figure/figure_words.h"
#include "homework/exercises.h"
#include "refused.h"

namespace {

using namespace vidno;
using namespace vidno::cli;

std::vector<std::string> words(const auto& names) { return {names.begin(), names.end()}; }

const CLI::Validator an_edition = CLI::IsMember(words(edition_names)).description("");

const CLI::Validator a_kernel(
    [](const std::string& name) { return kernel_named(name) ? "" : name + " is not one of " + kernel_names(); },
    kernel_names());

/// The methods of polygons, and that of curves.
std::vector<std::string> all_methods() {
    auto methods = words(method_names);
    methods.emplace_back(floating_horizon_method);
    return methods;
}

constexpr auto method_of_scene = "Which algorithm [warnock, of a surface floating-horizon]";
constexpr auto a_scene_or_surface = "A scene file, vidno-scene/1 or vidno-surface/1; - for standard input";

void add_run_options(CLI::App& command, RunOptions& options, const char* scene, const char* method,
                     const std::vector<std::string>& methods) {
    command.add_option("SCENE", options.scene, scene)->required();
    command.add_option("--method", options.method, method)->check(CLI::IsMember(methods));
    command.add_option("--kernel", options.kernel, "Which arithmetic decides")->check(a_kernel)->capture_default_str();
    command.add_option("--edition", options.edition, "Which text of the procedures: see vidno methods")
        ->check(an_edition)
        ->type_name("EDITION")
        ->capture_default_str();
}

CLI::App& add_trace(CLI::App& app, RunOptions& options) {
    auto& command = *app.add_subcommand("trace", "Run a method and write down every step");
    add_run_options(command, options, a_scene_or_surface, method_of_scene, all_methods());
    command.add_option("--detail", options.detail, "How much: each level adds events to the one before")
        ->check(CLI::IsMember(words(detail_names)))
        ->capture_default_str();
    command.add_flag("--check", options.check, "Tell the truth beside each decision, and which are wrong");
    command.add_option("--max-events", options.most_events, "Stop after so many events, keep what was traced")
        ->check(CLI::NonNegativeNumber);
    command.add_option("-o", options.output, "The trace, .jsonl or .jsonl.gz; - for standard output")->required();
    command.footer("Example: vidno trace scene.json --method warnock --detail signs -o run.jsonl.gz");
    return command;
}

CLI::App& add_render(CLI::App& app, RunOptions& options) {
    auto& command = *app.add_subcommand("render", "Run a method and keep only the picture");
    add_run_options(command, options, a_scene_or_surface, method_of_scene, all_methods());
    command
        .add_option("-o", options.output,
                    "The picture, .png or .ppm, of a surface its lines, .svg, .pdf, .png or .tex, of weiler-atherton "
                    "also its regions, .json, .svg, .pdf or .tex; - writes PPM or SVG to standard output")
        ->required();
    command.footer("Example: vidno render scene.json --method zbuffer --kernel exact -o picture.png");
    return command;
}

CLI::App& add_check(CLI::App& app, CheckOptions& options) {
    auto& command = *app.add_subcommand("check", "Run a scene and hold every decision against the truth");
    command.add_option("SCENE|TRACE", options.input, "A scene file, or a trace (.jsonl, .jsonl.gz) to be run again")
        ->required();
    command
        .add_option("--method", options.method,
                    "Which algorithm [warnock, of a surface floating-horizon, or the trace's]")
        ->check(CLI::IsMember(all_methods()));
    command.add_option("--kernel", options.kernel, "Which arithmetic decides [double, or the trace's]")
        ->check(a_kernel);
    command.add_option("--edition", options.edition, "Which text of the procedures [corrected, or the trace's]")
        ->check(an_edition)
        ->type_name("EDITION");
    command.footer(
        "A decision is wrong because it rounded, or right for numbers that had drifted and wrong for the scene.\n"
        "The step is that of a trace of level signs. Exit status 1: a decision or a pixel is wrong.");
    return command;
}

CLI::App& add_shrink(CLI::App& app, ShrinkOptions& options) {
    auto& command = *app.add_subcommand("shrink", "Find the smallest scene that still fails, or does as this one does");
    add_run_options(command, options.run, "A scene file, vidno-scene/1; - for standard input",
                    "Which algorithm [warnock]", words(method_names));
    auto* keep =
        command.add_option("--keep", options.keep,
                           "failure: a wrong pixel, or if there is none a wrong decision of the same procedure; "
                           "picture: the picture that this run paints; decision: a step at the line --at");
    keep->check(CLI::IsMember({"failure", "picture", "decision"}))->capture_default_str();
    command.add_option("--at", options.at, "A line of the listing, such as PL5 or W13")
        ->check(CLI::IsMember(words(line_names)));
    command.add_option("-o", options.run.output, "The scene, .json; - for standard output")->required();
    command.footer(
        "What is left has no polygon, vertex or binary place of a coordinate to spare.\n"
        "Example: vidno shrink scene.json --kernel float --keep failure -o smallest.json");
    return command;
}

CLI::App& add_need(CLI::App& app, NeedOptions& options) {
    auto& command = *app.add_subcommand("need", "Find out how little of a scene, and of arithmetic, its picture needs");
    command.add_option("SCENE", options.scene, "A scene file, vidno-scene/1; - for standard input")->required();
    command.add_option("-o", options.output, "The polygons and vertices that are needed, as a scene");
    command.footer(
        "Each line says what one less would change. Polygons and vertices are left out first; the rest is\n"
        "asked of what remains, each with the others as they are.");
    return command;
}

CLI::App& add_choose(CLI::App& app, ChooseOptions& options) {
    auto& command =
        *app.add_subcommand("choose", "Find the cheapest method and kernel whose picture is certainly right");
    command.add_option("SCENE", options.scene, "A scene file, vidno-scene/1; - for standard input")->required();
    command.footer("Times are medians of five interleaved runs, relative to the fastest.");
    return command;
}

CLI::App& add_map(CLI::App& app, MapOptions& options) {
    auto& command =
        *app.add_subcommand("map", "Ask one decision at 256 x 256 places of a point, and the truth beside it");
    command.add_option("DECISION", options.decision, "A file of a decision, vidno-question/1; - for standard input")
        ->required();
    command.add_option("--kernel", options.kernel, "Which arithmetic decides")->check(a_kernel)->capture_default_str();
    command.add_option("-o", options.output,
                       "The map, .png or .ppm; or .json: how often each answer is right and wrong");
    command.footer(
        "In the picture orange is negative, blue positive, white or black zero; dark differs from the exact answer.\n"
        "Example: vidno map lessons/maps/kettner-2a.json -o a.png\n"
        "Exit status 1: at some place the answer is wrong.");
    return command;
}

/// Those of charts of scenes and of surfaces.
void add_axes(CLI::App& command, AxisOptions& axes, const char* what_cost) {
    const auto all = [](auto names, const auto& more) {
        for (const auto& name : more) {
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
        return names;
    };
    command.add_option("--cost", axes.cost, what_cost)
        ->check(CLI::IsMember(all(names_of(cost_axes), names_of(surface_cost_axes))));
    command.add_option("--error", axes.error, "And from below [wrongPixels, of surfaces wrongColumns]")
        ->check(CLI::IsMember(all(names_of(error_axes), names_of(surface_error_axes))));
}

CLI::App& add_chart(CLI::App& app, ChartOptions& options) {
    auto& command =
        *app.add_subcommand("chart", "Chart what accuracy costs: every method, kernel and edition, and knobs");
    command
        .add_option("SCENE", options.scenes,
                    "Scene files, vidno-scene/1, or surface files, vidno-surface/1, with a function")
        ->required();
    add_axes(command, options.axes, "What .svg has from left to right [time]");
    command.add_option("-o", options.output, "The chart, .json, .csv, .svg (by gnuplot) or .html (a page)")->required();
    command.footer(
        "Knobs: bits of arithmetic, bits of the Z-buffer, bits of the grid, smallest window; of surfaces samples a\n"
        "curve, and tolerance. Times are medians of five interleaved runs, relative to the fastest; operations repeat\n"
        "exactly.\n"
        "The page has all costs and errors to choose from, says which run is needed and why, and leads from each to\n"
        "its replay.\n"
        "Examples: vidno chart lessons/charts/*.json -o chart.html\n"
        "          vidno chart lessons/surfaces/*.json -o surfaces.html");
    return command;
}

CLI::App& add_replay(CLI::App& app, ReplayOptions& options) {
    auto& command = *app.add_subcommand("replay", "Rebuild the picture from the events of a trace alone");
    command.add_option("TRACE", options.trace, "A trace, .jsonl or .jsonl.gz; - for standard input")->required();
    command.add_option("--step", options.step, "After so many events; without it, at the end");
    command
        .add_option(
            "-o", options.output,
            "The picture, .png or .ppm, of curves .svg, .pdf, .png or .tex; or .json: the whole state at that step; or "
            ".jsonl: at every step")
        ->required();
    command.footer("Exit status 1: the trace was cut short, is partial, or paints another picture than it says.");
    return command;
}

CLI::App& add_diff(CLI::App& app, DiffOptions& options) {
    auto& command = *app.add_subcommand("diff", "Find the first step where two traces part");
    command.add_option("A", options.first, "A trace")->required();
    command.add_option("B", options.second, "Another, for example of another kernel")->required();
    command.footer("Headers are not compared. Exit status 1: the traces part.");
    return command;
}

CLI::App& add_page(CLI::App& app, PageOptions& options) {
    auto& command = *app.add_subcommand("page", "Make one page of traces and scenes that opens from disk");
    command.add_option("SCENE|TRACE", options.files,
                       "Scene files, and traces (.jsonl, .jsonl.gz); without any, the page has the lessons");
    command.add_option("-o", options.output, "The page, .html; - for standard output")->required();
    command.footer(
        "The page has all it shows in itself and opens the first one; a scene it runs itself.\n"
        "Example: vidno page run.jsonl.gz scene.json -o lecture.html\n"
        "Exit status 1: a trace was cut short or is partial; the page has what there is of it.");
    return command;
}

CLI::App& add_lesson(CLI::App& app, LessonOptions& options, int& status) {
    auto& command =
        *app.add_subcommand("lesson", "Write a lesson: its first files, its pins, a check, the built course");
    command.require_subcommand(0, 1);  // one; but a wrong one is told before none
    const auto add_folders = [&](CLI::App& sub) {
        sub.add_option("FOLDER", options.folders, "Folders of lessons")->required();
    };

    auto& made = *command.add_subcommand("new", "Make the folder of a lesson from a scene or a mesh");
    made.add_option("SCENE|MESH", options.source, "A scene or surface file, or a mesh: .obj, .off, .ply or .stl")
        ->required();
    made.add_option("-o", options.output, "The folder, which is not there yet")->required();
    made.footer("Example: vidno lesson new scene.json -o lessons/11-my-topic");
    made.callback([&] { status = lesson_new(options); });

    auto& pin = *command.add_subcommand("pin", "Say how to pin a step, as a line for lesson.json");
    add_folders(pin);
    pin.add_option("--run", options.run, "Of which run [the first]");
    pin.add_option("--step", options.step, "Which step, as the page counts them")->required();
    pin.callback([&] { status = lesson_pin(options); });

    auto& check = *command.add_subcommand("check", "Say what is wrong with lessons, with file and line");
    add_folders(check);
    check.footer("Exit status 1: something is wrong.");
    check.callback([&] { status = lesson_check(options); });

    auto& build = *command.add_subcommand("build", "Trace lessons and place their pins, for the page");
    add_folders(build);
    build.add_option("-o", options.output, "The folder of the course")->required();
    build.footer("Exit status 1: something is wrong, as lesson check says it; the rest is built.");
    build.callback([&] { status = lesson_build(options); });
    return command;
}

CLI::App& add_grade(CLI::App& app, GradeOptions& options) {
    auto& command =
        *app.add_subcommand("grade", "Judge a student's program, or its trace, by the meaning of each step");
    command
        .add_option(
            "PROGRAM|TRACE", options.program,
            "A program that writes a trace by lessons/student/vidno_student.h, or such a trace (.jsonl, .jsonl.gz)")
        ->required();
    command.add_option("--scenes", options.scenes, "Scene files to run it on; without them, on a set of small ones");
    command.add_option("--seconds", options.seconds, "How long a run may take")
        ->check(CLI::Range(1, 3600))
        ->capture_default_str();
    command.add_option("-o", options.output,
                       "A page, .html, with the wrong run on the smallest scene beside the right one");
    command.footer(
        "Another order, another rule for outlines, recursion and float are as right. The program is run with limits "
        "of\n"
        "time, memory and output, which guard against mistakes, not against malice.\n"
        "Example: vidno grade ./warnock -o report.html\n"
        "Exit status 1: something is wrong.");
    return command;
}

/// The option's three numbers, x y z, become a vector of the camera; naming any of them makes a camera.
void add_vector(CLI::App& command, ImportOptions& import, const std::string& name, glm::dvec3 Camera::*target,
                const std::string& help) {
    const auto set = [&import, target](const std::vector<double>& xyz) {
        if (!import.camera) import.camera.emplace();
        *import.camera.*target = {xyz[0], xyz[1], xyz[2]};
    };
    command.add_option_function<std::vector<double>>(name, set, help)->expected(3)->type_name("X Y Z");
}

void add_length(CLI::App& command, ImportOptions& import, const std::string& name, double Camera::*target,
                const std::string& help) {
    const auto set = [&import, target](double value) {
        if (!import.camera) import.camera.emplace();
        *import.camera.*target = value;
        if (target == &Camera::height) import.camera->projection = Projection::orthographic;
    };
    command.add_option_function<double>(name, set, help);
}

/// The options that place the camera.
void add_camera_options(CLI::App& command, ImportOptions& import) {
    command.add_option("--width", import.width, "Of the picture, in pixels")
        ->check(CLI::Range(1, largest_side))
        ->capture_default_str();
    command.add_option("--height", import.height, "Of the picture, in pixels")
        ->check(CLI::Range(1, largest_side))
        ->capture_default_str();
    auto& camera = *command.add_option_group("Camera", "Without --eye it shows the whole mesh, a little from above");
    add_vector(camera, import, "--eye", &Camera::eye, "Where it stands");
    add_vector(camera, import, "--target", &Camera::target, "What it looks at; the origin if not said");
    add_vector(camera, import, "--up", &Camera::up, "What is up; 0 1 0 if not said");
    add_length(camera, import, "--fov", &Camera::field_of_view,
               "Perspective: the vertical angle; 45 degrees if not said");
    add_length(camera, import, "--ortho", &Camera::height, "Parallel projection instead: the height that is seen");
    add_length(camera, import, "--near", &Camera::near_distance, "What is nearer is cut off; 0.1 if not said");
    add_length(camera, import, "--far", &Camera::far_distance, "What is farther is cut off; 100 if not said");
    for (auto* option : camera.get_options()) {
        if (option->get_name() != "--eye") option->needs("--eye");
    }
}

CLI::App& add_import(CLI::App& app, MeshOptions& options) {
    auto& command = *app.add_subcommand("import", "Make a scene from a mesh seen by a camera");
    command.add_option("MESH", options.mesh, "A mesh: .obj, .off, .ply or .stl")->required();
    add_camera_options(command, options.import);
    command.add_option("-o", options.output, "The scene, .json; - for standard output")->required();
    command.footer("Faces that are not planar or not convex are cut into triangles; what is dropped is said.");
    return command;
}

CLI::App& add_homework(CLI::App& app, HomeworkOptions& options) {
    auto& command = *app.add_subcommand("homework", "Make scenes as hard as this one, with other numbers");
    command.alias("variants");  // as it was called before
    command.add_option("SCENE", options.scene, "A scene file, vidno-scene/1; - for standard input")->required();
    command.add_option("--count", options.count, "How many")
        ->check(CLI::Range(std::size_t{1}, most_exercises))
        ->capture_default_str();
    command.add_option("--seed", options.seed, "Another one, other scenes")->capture_default_str();
    command.add_option("--method", options.method, "By which algorithm they are as hard")
        ->check(CLI::IsMember(words(course_method_names)))
        ->capture_default_str();
    command.add_option("-o", options.output, "The folder, which is not there yet: 01.json and so on")->required();
    command.footer(
        "As hard: the same lines of the listing are reached and the same cases met, as often but for a tenth.\n"
        "Example: vidno homework scene.json --count 30 --seed 7 -o homework\n"
        "Exit status 1: there are fewer than wanted.");
    return command;
}

CLI::App& add_worksheet(CLI::App& app, WorksheetOptions& options) {
    auto& command =
        *app.add_subcommand("worksheet", "Print scenes with tables to be filled in by hand, or ask about a run");
    command.add_option("SCENE|TRACE", options.files, "For .pdf scene files, vidno-scene/1; for .xml one trace")
        ->required();
    command.add_option("--language", options.language, "Of the words in it")
        ->check(CLI::IsMember(words(figures::language_codes)))
        ->capture_default_str();
    command.add_option("--method", options.method, "Of .pdf: which algorithm is worked [warnock]")
        ->check(CLI::IsMember(words(course_method_names)));
    command.add_option("--key", options.key, "Of .pdf: the same sheets filled in, .pdf");
    command
        .add_option("--count", options.count, "Of .xml: at most so many questions, spread over the run's kinds [20]")
        ->check(CLI::Range(1, 9999));
    command
        .add_option("-o", options.output,
                    "The blank sheets, one scene after the other, .pdf; or what the run does next, as questions for "
                    "Moodle, .xml")
        ->required();
    command.footer(
        "Examples: vidno worksheet homework/*.json -o sheets.pdf --key keys.pdf\n"
        "          vidno worksheet run.jsonl.gz --language ru -o questions.xml   (needs Node)");
    return command;
}

CLI::App& add_stability(CLI::App& app, StabilityOptions& options) {
    auto& command = *app.add_subcommand("stability", "Run thousands of random scenes and count what is wrong");
    auto& campaign = options.campaign;
    command.add_option("--family", campaign.families, "Scenes of which kind [all]: see below");
    command.add_option("--kernel", campaign.kernels, "Which arithmetic decides [float, double, filtered]")
        ->check(a_kernel);
    command.add_option("--method", campaign.methods, "Which algorithm [warnock, zbuffer]")
        ->check(CLI::IsMember(words(course_method_names)));
    command.add_option("--count", campaign.count, "Trials of each experiment in each family; fewer of dear ones")
        ->check(CLI::Range(std::uint64_t{1}, most_trials))
        ->capture_default_str();
    command.add_option("--seed", campaign.seed, "Another one, other scenes")->capture_default_str();
    command.add_option("--shard", options.shard, "K/N: of the blocks of trials only each N-th, from the K-th");
    auto* merge = command.add_option("--merge", options.merged, "Run nothing: put these files of results together");
    command.add_option("-o", options.output,
                       "Keep the results, .jsonl; a run that was killed goes on where it stopped");
    for (const char* of_run : {"--family", "--kernel", "--method", "--count", "--seed", "--shard"}) {
        merge->excludes(of_run);
    }
    command.footer(stability_footer());
    return command;
}

CLI::App& add_figure(CLI::App& app, FigureOptions& options) {
    auto& command = *app.add_subcommand("figure", "Draw steps of a trace, a map or a chart for a paper or a slide");
    command
        .add_option("TRACE|LESSON|DECISION|CHART", options.input,
                    "A trace, .jsonl or .jsonl.gz, - for standard input; the folder of a lesson; or a decision to be "
                    "mapped or a "
                    "chart, .json")
        ->required();
    auto* step = command.add_option("--step", options.step, "After so many events; without it, at the end");
    auto* steps = command.add_option("--steps", options.steps, "A film strip: N,M,... or A..B or A..B:BY");
    command.add_option("--pin", options.pin, "Of a lesson: the step of this pin")->excludes(step)->excludes(steps);
    steps->excludes(step);
    command
        .add_option("--show", options.show,
                    "Of picture, windows (of Z-buffer the scanline, of curves the horizons, of weiler-atherton the "
                    "lists), list (APL or AEL, or its list), listing, history")
        ->capture_default_str();
    command.add_option("--pixel", options.pixel, "X,Y: whose history is shown");
    command.add_option("--language", options.language, "Of the words in it")
        ->check(CLI::IsMember(words(figures::language_codes)))
        ->capture_default_str();
    command.add_option("--width", options.width, "In cm or mm [8cm; of a film strip 17cm, of a slide 14cm]");
    command.add_option("--kernel", options.kernel, "Of a map: which arithmetic decides")
        ->check(a_kernel)
        ->capture_default_str();
    add_axes(command, options.axes, "Of a chart: what it has from left to right [time]");
    command.add_option("--dpi", options.dots_an_inch, "Of .png")->check(CLI::Range(30, 2400))->capture_default_str();
    command.add_flag("--greyscale", options.greyscale, "No colours, and textures that are darker");
    command.add_flag("--beamer", options.beamer, "A slide with an overlay a step, .tex");
    command.add_option("-o", options.output, "The figure, .svg, .pdf, .png or .tex; - writes SVG to standard output")
        ->required();
    command.footer(
        "Example: vidno figure run.jsonl.gz --step 40 --show picture,windows,list,listing -o figure.pdf\n"
        "The .tex stands alone under pdfLaTeX, and can be \\input into a document, whose font it then has.");
    return command;
}

/// Help is printed as CLI11 has it; every error is one line and status 2.
int refuse(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "vidno: " << error.what() << " (vidno --help)\n";
    return 2;
}

}  // namespace

namespace vidno::cli {

FigureOptions figure_options(const std::string& command) {
    CLI::App app("", "vidno");
    app.require_subcommand(1);
    FigureOptions options;
    add_figure(app, options);
    try {
        app.parse(command, true);
    } catch (const CLI::ParseError& error) {
        throw Refused(error.what());
    }
    return options;
}

}  // namespace vidno::cli

int main(int argc, char** argv) {
    CLI::App app{"vidno runs the textbook hidden-surface procedures one small step at a time.", "vidno"};
    app.require_subcommand(0, 1);  // one; but a wrong one is told before none
    app.set_version_flag("--version", "vidno " VIDNO_VERSION);
    app.get_formatter()->column_width(28);
    app.footer("vidno COMMAND --help says more. Exit status: 0 done; 1 done, and something was found; 2 refused.");

    RunOptions run;
    CheckOptions checked;
    ShrinkOptions shrinking;
    NeedOptions needed;
    ChooseOptions choosing;
    MapOptions mapped;
    ChartOptions charted;
    ReplayOptions replayed;
    FigureOptions drawn;
    DiffOptions compared;
    PageOptions paged;
    LessonOptions lesson;
    GradeOptions graded;
    HomeworkOptions exercises;
    WorksheetOptions printed;
    MeshOptions mesh;
    StabilityOptions campaign;
    int status = 0;
    add_trace(app, run).callback([&] { status = trace(run); });
    add_render(app, run).callback([&] { status = render(run); });
    add_check(app, checked).callback([&] { status = check(checked); });
    add_shrink(app, shrinking).callback([&] { status = shrink(shrinking); });
    add_need(app, needed).callback([&] { status = need(needed); });
    add_choose(app, choosing).callback([&] { status = choose(choosing); });
    add_map(app, mapped).callback([&] { status = map(mapped); });
    add_chart(app, charted).callback([&] { status = chart(charted); });
    add_replay(app, replayed).callback([&] { status = replay(replayed); });
    add_figure(app, drawn).callback([&] { status = figure(drawn); });
    add_diff(app, compared).callback([&] { status = diff(compared); });
    add_page(app, paged).callback([&] { status = page(paged); });
    auto& lessons = add_lesson(app, lesson, status);
    add_grade(app, graded).callback([&] { status = grade(graded); });
    add_homework(app, exercises).callback([&] { status = homework(exercises); });
    add_worksheet(app, printed).callback([&] { status = worksheet(printed); });
    add_import(app, mesh).callback([&] { status = import(mesh); });
    add_stability(app, campaign).callback([&] { status = stability(campaign); });
    bool methods_as_json = false;
    auto& what_there_is = *app.add_subcommand("methods", "What there is: methods, kernels, editions, levels");
    what_there_is.add_flag("--json", methods_as_json,
                           "As JSON: also which edition of which method runs under which kernel");
    what_there_is.callback([&] { status = methods(methods_as_json); });

    try {
        app.parse(argc, argv);
        const bool is_named =
            !app.get_subcommands().empty() && (!lessons.parsed() || !lessons.get_subcommands().empty());
        if (!is_named) throw CLI::RequiredError::Subcommand(1);
        return status;
    } catch (const CLI::ParseError& error) {
        return refuse(app, error);
    } catch (const Refused& refused) {
        std::cerr << "vidno: " << refused.what() << '\n';
    } catch (const std::bad_alloc&) {
        std::cerr << "vidno: not enough memory\n";
    }
    return 2;
}
