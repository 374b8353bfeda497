/// StudentRun: a student's program on a scene: how it ended, and what it told.
#pragma once

#include "grade/contained.h"
#include "grade/judge.h"

namespace vidno {

struct StudentRun {
    Ended ended;
    std::string trace;                  // the file, as it is; empty if there is none
    std::optional<TraceHeader> header;  // none if the file has none that can be read
    std::vector<Event> events;
    bool complete = false;   // the trace has its last line
    std::string unreadable;  // why reading stopped early; empty if it did not
};

/// The scene as `scene_to_draw` of lessons/student/vidno_student.h reads it.
std::string scene_text(const Scene& scene);

/// Reads what there is of a trace of one of the kernels `float` and `double`.
StudentRun read_student_trace(std::string text);

/// Throws Refused if the program cannot be started.
StudentRun run_student(const std::filesystem::path& program, const Scene& scene, const Limits& limits);

/// Whether it is the same scene for the judge: polygons in any order, from any first vertex, in either direction.
bool same_scene(const Scene& told, const Scene& given);

}  // namespace vidno
