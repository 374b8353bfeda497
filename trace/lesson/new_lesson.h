/// New lessons, and pins for the steps that an author has in mind.
#pragma once

#include <map>
#include <string>

#include "lesson.h"

namespace vidno {

/// The files of a lesson on a scene, by name, besides `scene.json`. The stories say TODO where there is to be written.
std::map<std::string, std::string> new_lesson(const AnyScene& scene);

/// A pin of a step, as JSON: the window, polygon and row, or curve and column, in which it is taken, and who or what it is
/// about. Throws Refused if the run has no such step.
std::string pin_of_step(const AnyScene& scene, const LessonRun& run, std::uint64_t step);

}  // namespace vidno
