/// Story: the text of a lesson in one language, GitHub Markdown turned into blocks that a page can display.
///
/// lessons/WRITING.md tells authors what a story may contain; trace/LESSON.md describes the blocks.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "choice/language.h"
#include "problem.h"

namespace vidno {

/// The headings of level 2 that begin the summary and the exercises.
inline constexpr Bilingual summary_heading{"Summary", "Итоги"};
inline constexpr Bilingual exercises_heading{"Exercises", "Упражнения"};

struct Story {
    /// Something that the story has in every language, in the order of the text: "heading 2", "pin split".
    struct Mark {
        int line;
        std::string what;
    };
    /// A link to a pin, and its words.
    struct PinLink {
        int line;
        std::string pin, words;
    };
    struct Figure {
        int line;
        std::string command, file;
    };

    std::string file;
    std::string plain_title;
    nlohmann::ordered_json title = nlohmann::ordered_json::array();
    nlohmann::ordered_json goals = nlohmann::ordered_json::array();  // what the reader can do afterwards, each a text
    nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
    std::vector<Mark> marks;
    std::vector<PinLink> pins;
    std::vector<Mark> lessons;  // that it links to, by their folders' names
    std::vector<Figure> figures;
    int questions = 0, exercises = 0;
    bool has_summary = false;
};

/// Reads a story. Adds to the problems what a page could not show, and required parts that are missing.
Story read_story(std::string_view markdown, Language language, const std::string& file, Problems& problems);

/// Removes the answers to questions and exercises from the blocks of a story.
void omit_answers(nlohmann::ordered_json& blocks);

/// Adds the places where the second story's structure differs from the first.
void compare_structure(const Story& first, const Story& second, Problems& problems);

}  // namespace vidno
