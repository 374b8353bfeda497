/// Failure files, `vidno-failure/1`: a scene on which a run fails, the run that holds, and what can be seen. The atlas,
/// lessons/failures, consists of these.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "choice/kernel_choice.h"
#include "scene/surface.h"

namespace vidno {

/// How a scene is run.
struct NamedRun {
    std::string method;
    NamedKernel kernel;
    Edition edition{};
};

/// What can be seen of a failure, in one of the forms that its file may use.
struct Shows {
    std::optional<std::pair<int, int>> pixel;  // this pixel is painted wrong
    std::optional<std::pair<int, int>>
        column;  // a curve, by its index, and a column over which it is wrongly drawn or wrongly omitted
    std::optional<std::pair<int, double>> place;  // the same at an x between columns
    std::string wrong;                            // a procedure with a wrong decision
    std::string fault;                            // a line of the listing at which the run faults
    std::string missing, present;                 // a line that it does not reach, or that only it reaches
    bool more_windows = false;                    // it has more windows than the run that holds
    std::optional<double> off;                    // the error of an intersection, in pixels
};

struct Failure {
    using Words = InEachLanguage<std::string>;
    Words title, why, remedy;
    std::string source;             // published; may be empty
    std::string test;               // the name of the test that shows it, if no scene can
    std::optional<AnyScene> scene;  // one of these two
    // Only for a failure with a scene.
    NamedRun fails, holds;
    std::optional<AnyScene> holds_scene;  // if the run that holds has one of its own
    Shows shows;
    std::vector<std::string> warnings;  // of the scene
};

/// Whether a file is a failure, by its contents.
bool is_failure(std::string_view text);

/// `text` is the JSON, `file` its name in messages. Throws Refused, with a line for each fault.
Failure read_failure(std::string_view text, const std::string& file);
/// Reads a failure from its document. Throws Misread.
Failure read_failure(const JsonNode& root, const std::string& file);

}  // namespace vidno
