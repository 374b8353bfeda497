/// The commands of the program, one function each. They give the exit status (0 done, 1 done and something was found)
/// and throw Refused for what they do not take.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "chart/chart_input.h"
#include "format/trace_reader.h"
#include "import/import.h"
#include "page/page.h"
#include "run/run.h"
#include "scene/surface.h"
#include "stability/stability.h"

namespace vidno::cli {

struct RunOptions {
    std::string scene, output;
    std::optional<std::string> method;  // none: warnock, of a surface floating-horizon
    std::string kernel = "double", edition = "corrected", detail = "signs";
    std::uint64_t most_events = TraceWriter::no_limit;
    bool check = false;
};

/// A scene, or a trace whose scene is run again; what is not given is the trace's own, or the default.
struct CheckOptions {
    std::string input;
    std::optional<std::string> method, kernel, edition;
};

struct ShrinkOptions {
    RunOptions run;
    std::string keep = "failure";
    std::string at;  // the label of a line, for "decision"
};

struct NeedOptions {
    std::string scene, output;  // the output may be empty
};

struct ChooseOptions {
    std::string scene;
};

struct MapOptions {
    std::string decision, output;  // no output: the table alone
    std::string kernel = "double";
};

/// Which cost and error of a chart a figure has; none: the first one.
struct AxisOptions {
    std::optional<std::string> cost, error;
};

struct ChartOptions {
    std::vector<std::string> scenes;
    std::string output;
    AxisOptions axes;  // of the figure
};

struct ReplayOptions {
    std::string trace, output;
    std::optional<std::uint64_t> step;
};

struct FigureOptions {
    std::string input, output;
    std::optional<std::uint64_t> step;
    std::string steps, pin, pixel, width;  // empty: as usual
    std::string show = "picture,windows";
    std::string language = "en";
    std::string kernel = "double";  // of a map
    AxisOptions axes;               // of a chart
    int dots_an_inch = 300;
    bool greyscale = false, beamer = false;
};

struct DiffOptions {
    std::string first, second;
};

struct PageOptions {
    std::vector<std::string> files;
    std::string output;
};

struct LessonOptions {
    std::vector<std::string> folders;
    std::string source, output;  // of a new one: a scene or a mesh; the folder
    std::string run;             // of a pin: the run's name, empty for the first
    std::uint64_t step = 0;
};

struct GradeOptions {
    std::string program, output;      // or a trace; the output may be empty
    std::vector<std::string> scenes;  // none: those of the program
    int seconds = 10;
};

struct HomeworkOptions {
    std::string scene, output;
    std::string method = "warnock";
    std::size_t count = 30;
    std::uint64_t seed = 1;
};

struct WorksheetOptions {
    std::vector<std::string> files;  // scenes for sheets, one trace for questions
    std::string language = "en", output;
    std::optional<std::string> method, key;  // of sheets
    std::optional<int> count;                // of questions
};

struct MeshOptions {
    std::string mesh, output;
    ImportOptions import;
};

struct StabilityOptions {
    Campaign campaign;
    std::string shard = "1/1", output;
    std::vector<std::string> merged;
};

/// What there is for a campaign, for the help.
std::string stability_footer();

/// The options of a command `figure` as the shell takes it, "vidno figure ...". Throws Refused.
FigureOptions figure_options(const std::string& command);

/// The place of a name that the command line has checked.
std::size_t place_in(const auto& names, const std::string& name) {
    return std::size_t(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Of polygons.
inline Method method_of(const RunOptions& options) {
    return Method(place_in(method_names, options.method.value_or("warnock")));
}
inline Edition edition_of(const RunOptions& options) { return Edition(place_in(edition_names, options.edition)); }

/// Refuses a method or an edition that the kernel does not run.
void expect_run(const NamedKernel& kernel, Method method, Edition edition);

/// Refuses a scene outside the method's domain.
void expect_admitted(Method method, const Scene& scene, const std::string& file);

/// Refuses a kernel or an edition that does not run curves.
void expect_floating_horizon_run(const NamedKernel& kernel, Edition edition);

/// The kernel of the options, if it runs their method and edition.
NamedKernel kernel_of(const RunOptions& options);

/// The scene of a file, of polygons; warnings go to standard error.
Scene scene_from(const std::string& file);
/// The same of its text.
Scene scene_of(std::string_view text, const std::string& file);

/// A scene of polygons or of curves, which must be that of the method, if there is one.
AnyScene any_scene_from(const std::string& file, const std::optional<std::string>& method);

/// Whether a file is a trace, by its name.
inline bool is_trace(const std::string& file) { return file.ends_with(".jsonl") || file.ends_with(".jsonl.gz"); }

/// After the last event: whether the trace is of a whole run. If not, it is said on standard error.
bool is_whole(const TraceFile& trace);

/// The scene as the kernel runs it: snapped for `grid`, which is said on standard error; else as it is.
Scene scene_for(const NamedKernel& kernel, Scene scene, const std::string& file);

/// Of things that have one, in their order.
std::vector<std::string> names_of(const auto& named) {
    std::vector<std::string> names;
    for (const auto& each : named) names.emplace_back(each.name);
    return names;
}

/// The program that draws a chart by the axes that are named; refuses those that a chart of this kind has not.
std::string script_of(const std::vector<SceneChart>& scenes, const AxisOptions& axes, const PlotLayout& layout = {},
                      bool in_russian = false);
std::string script_of(const std::vector<SurfaceChart>& surfaces, const AxisOptions& axes, const PlotLayout& layout = {},
                      bool in_russian = false);

int trace(const RunOptions& options);
int render(const RunOptions& options);
int check(const CheckOptions& options);
int shrink(const ShrinkOptions& options);
int need(const NeedOptions& options);
int choose(const ChooseOptions& options);
int map(const MapOptions& options);
int chart(const ChartOptions& options);
int replay(const ReplayOptions& options);
int figure(const FigureOptions& options);
/// The bytes of the figure, in the format that the output's name says.
std::string drawn_figure(const FigureOptions& options);
int diff(const DiffOptions& options);
int page(const PageOptions& options);
/// Builds a lesson into a page. False if something is wrong with it, which is said.
bool add_lesson(const std::string& folder, PageContent& content);
int lesson_new(const LessonOptions& options);
int lesson_pin(const LessonOptions& options);
int lesson_check(const LessonOptions& options);
int lesson_build(const LessonOptions& options);
int grade(const GradeOptions& options);
int homework(const HomeworkOptions& options);
int worksheet(const WorksheetOptions& options);
/// The part of `worksheet` that writes .xml, from a trace, by Node.
int moodle_questions(const WorksheetOptions& options);
int import(const MeshOptions& options);
int stability(const StabilityOptions& options);
int methods(bool as_json);

}  // namespace vidno::cli
