/// A lesson with its traces and figures, for a course or a page.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lesson/lesson.h"

namespace vidno::cli {

/// The entry of a lesson in the index of a course, and the files that the entry names.
struct BuiltLesson {
    nlohmann::ordered_json entry;
    std::vector<std::pair<std::string, std::string>> traces;
    std::string story_name, story;
};

/// Adds the errors of the lesson to the problems.
BuiltLesson built_lesson(const std::string& folder, Answers answers, Problems& problems);

/// Adds `--no-answers`, which sets the value.
void add_no_answers(CLI::App& command, Answers& answers);

/// Draws the figures of both stories, and adds their errors to the problems.
void check_figures(const Lesson& lesson, Problems& problems);

/// Prints the problems on standard error. Returns the exit status.
int status_after(const Problems& problems);

}  // namespace vidno::cli
