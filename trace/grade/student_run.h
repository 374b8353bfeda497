/// StudentRun: how a student's program ended on a scene, and the trace that it wrote.
#pragma once

#include "grade/contained.h"
#include "grade/judge.h"

namespace vidno {

struct StudentRun {
    Ended ended;
    std::string trace;                // the text of the file; empty if there is none
    std::optional<AnyHeader> header;  // none if it cannot be read
    std::vector<Event> events;
    bool complete = false;   // the trace has its last line
    std::string unreadable;  // why reading stopped early; empty if it did not
};

/// A scene that a program is to draw, or has drawn.
using DrawnScene = std::variant<Scene, Surface>;

/// The scene of a trace.
DrawnScene scene_of(const AnyHeader& header);
/// Its name.
const std::string& name_of(const DrawnScene& scene);

/// The scene as `scene_to_draw` of lessons/student/vidno_student.h reads it.
std::string scene_text(const Scene& scene);
/// The surface as `surface_to_draw` reads it.
std::string scene_text(const Surface& surface);

/// Reads a trace of the kernel `float` or `double`, as far as it is readable.
StudentRun read_student_trace(std::string text);

/// Offers the scenes, at most one of each kind, to the program. Runs it, contained, and reads its trace. Throws Refused
/// if the program cannot be started.
StudentRun run_student(ContainedProgram& program, const std::vector<DrawnScene>& scenes);

/// Whether the scenes are the same for the judge: polygons may come in any order, start at any vertex and run in either
/// direction.
bool same_scene(const Scene& claimed, const Scene& given);
/// Whether scenes of either kind are the same for the judge. Curves must be equal.
bool same_scene(const DrawnScene& claimed, const DrawnScene& given);

}  // namespace vidno
