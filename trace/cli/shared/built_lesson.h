/// A lesson with its traces and figures made, for a course or a page.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lesson/lesson.h"

namespace vidno::cli {

/// What the index of a course says of a lesson, and the files that this names.
struct BuiltLesson {
    nlohmann::ordered_json entry;
    std::vector<std::pair<std::string, std::string>> traces;
    std::string story_name, story;
};

/// What is wrong with the lesson is added to the problems.
BuiltLesson built_lesson(const std::string& folder, Problems& problems);

/// The figures of both stories are drawn; what is wrong with them is added to the problems.
void check_figures(const Lesson& lesson, Problems& problems);

/// Says the problems on standard error. The exit status.
int status_after(const Problems& problems);

}  // namespace vidno::cli
