/// New lessons, and pins for steps that an author chooses.
#pragma once

#include <map>
#include <string>

#include "lesson.h"

namespace vidno {

/// The files of a lesson on a scene, by name, besides `scene.json`. The stories say TODO where the author must write.
std::map<std::string, std::string> new_lesson(const AnyScene& scene);

/// A pin for a step, as JSON: the window, polygon and row, or curve and column, in which it occurs, and the fields that
/// identify it. Throws Refused if the run has no such step.
std::string pin_of_step(const AnyScene& scene, const LessonRun& run, std::uint64_t step);

}  // namespace vidno
