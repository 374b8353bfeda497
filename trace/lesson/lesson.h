/// Lesson: a folder with scenes, runs of them, and a story in each language whose links are steps of the runs.
///
/// lessons/WRITING.md explains how to write one.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "format/floating_horizon_trace.h"
#include "pin.h"
#include "problem.h"
#include "run/run.h"
#include "story.h"

namespace vidno {

struct LessonRun {
    std::string name;
    InEachLanguage<std::string> title{};  // what it shows; may be empty
    std::string scene = "scene.json";     // a file of the lesson's folder, or a mesh
    std::string method;
    NamedKernel kernel = kernel_of(KernelKind::binary64);
    Edition edition = Edition::corrected;
    Detail detail = Detail::signs;
    bool check = false;

    bool of_curves() const { return method == floating_horizon_method; }

    /// The scene's name: that of its file without the extension; empty for `scene.json`.
    std::string other_scene() const;
    /// The file name of the trace, for the lesson with this name.
    std::string trace_file(const std::string& lesson) const;
};

/// The method of a run of polygons.
Method method_of(const LessonRun& run);

/// The parts of a procedure's state that a lesson may show beside its text; a run has those of its method.
inline constexpr std::array<std::string_view, 13> state_parts{
    "window", "corner-depths", "active-polygons", "stack", "scanline",   "active-edges", "z-buffer",
    "list",   "parts",         "visible",         "curve", "side-edges", "horizons"};

/// What a lecturer must know to place a lesson in a course. A member without a value is missing in lesson.json.
struct Frame {
    /// A publication of the list of sources by its key, and the chapter to read; without one, all of it.
    struct Reading {
        std::string key;
        std::string chapter{};
    };
    /// Another lesson, which has to come first, with its title.
    struct Prerequisite {
        std::string id;
        InEachLanguage<std::string> title{};
    };

    std::optional<int> minutes;  // in class, without the exercises
    std::optional<std::vector<Prerequisite>> prerequisites;
    InEachLanguage<std::string> assumes{};  // what the reader must know besides; may be empty
    std::optional<std::vector<Reading>> sources;
    nlohmann::json bibliography;  // sources.json of the folder that contains the lessons, by key
};

struct Lesson {
    std::string folder;           // as it was given, without a slash at its end
    std::filesystem::path place;  // the same, from the root
    std::string id;               // its name
    std::vector<LessonRun> runs;
    std::vector<Pin> pins;
    std::vector<std::string> shows{};  // parts of the state, among `state_parts`
    InEachLanguage<Story> stories;
    Frame frame{};

    std::string file(const std::string& name) const { return folder + '/' + name; }
    /// The run with this name, which must exist.
    const LessonRun& run(const std::string& name) const;
};

/// The name of the file of its story.
inline std::string story_file(Language language) { return "story." + std::string(code_of(language)) + ".md"; }

/// Reads the files of a lesson, and adds their errors to the problems. Throws Refused if the folder is not a lesson.
Lesson read_lesson(const std::string& folder, Problems& problems);

/// Adds inconsistencies between pins, stories, and the lessons beside this one.
void check_lesson(const Lesson& lesson, Problems& problems);

/// The scene of a run, of the kind that its method takes; a mesh is seen by the default camera. Throws Refused.
AnyScene scene_of(const Lesson& lesson, const LessonRun& run);

/// Traces a scene like a run of a lesson.
void trace_run(const AnyScene& scene, const LessonRun& run, const TraceWriter::Write& write);

/// The steps of pins, by their names.
using Steps = std::map<std::string, std::uint64_t>;

/// Runs the lesson and finds its pins. `take` gets each trace in pieces. Adds to the problems each claim of a pin that
/// the run contradicts, and what a scene lacks of its mesh.
/// Throws Refused for a scene that is refused.
Steps run_lesson(const Lesson& lesson, Problems& problems,
                 const std::function<void(const LessonRun&, std::string_view)>& take = {});

/// The figures of a story as SVG, by the names of their files.
using Figures = std::map<std::string, std::string>;

/// Whether a built lesson has the answers to its questions and exercises.
enum class Answers : unsigned char { included, omitted };

/// The lesson in the form that its page reads, on one line.
std::string lesson_json(const Lesson& lesson, const Steps& steps, const InEachLanguage<Figures>& figures,
                        Answers answers);

}  // namespace vidno
