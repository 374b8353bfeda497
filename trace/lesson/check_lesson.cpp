#include <algorithm>
#include <filesystem>

#include "lesson.h"
#include "output.h"

namespace vidno {

namespace {

/// Whether the words contain the number, with any separator of thousands: 1365, 1,365, 1 365.
bool tell_number(const std::string& words, std::uint64_t number) {
    std::string digits;
    for (const char c : words) {
        const bool is_digit = c >= '0' && c <= '9';
        if (is_digit || !(c == ',' || c == ' ' || c == '\xc2' || c == '\xa0')) digits += is_digit ? c : ' ';
    }
    return (' ' + digits + ' ').find(' ' + std::to_string(number) + ' ') != std::string::npos;
}

void check_pins(const Lesson& lesson, const Story& story, Problems& problems) {
    for (const auto& [line, name, words] : story.pins) {
        const auto pin = std::find_if(lesson.pins.begin(), lesson.pins.end(),
                                      [&, &called = name](const Pin& each) { return each.name == called; });
        if (pin == lesson.pins.end()) {
            problems.push_back({story.file, line, "lesson.json has no pin " + name});
        } else if (pin->times && !tell_number(words, *pin->times)) {
            const std::string number = std::to_string(*pin->times);
            problems.push_back(
                {story.file, line, "pin " + name + " counts " + number + ", its words do not: " + words});
        }
    }
}

void check_lessons(const Lesson& lesson, const Story& story, Problems& problems) {
    const auto beside = lesson.place.parent_path();
    for (const auto& [line, id] : story.lessons) {
        if (!std::filesystem::exists(beside / id / "lesson.json")) {
            problems.push_back({story.file, line, "there is no lesson " + id});
        }
    }
}

void check_written(const Story& story, Problems& problems) {
    if (story.file.empty()) return;
    LineReader lines(story.file);
    std::string text;
    for (int line = 1; lines.next(text); ++line) {
        if (text.find("TODO") != text.npos) problems.push_back({story.file, line, "is still to be written: " + text});
    }
}

void check_frame(const Lesson& lesson, Problems& problems) {
    const auto require = [&](const auto& member, const std::string& what) {
        if (!member) problems.push_back({lesson.file("lesson.json"), 1, what});
    };
    require(lesson.frame.minutes, "the minutes in class are missing: \"minutes\"");
    require(lesson.frame.prerequisites, "the lessons that come first are missing: \"prerequisites\"");
    require(lesson.frame.sources, "the sources are missing: \"sources\"");
}

bool is_used(const Pin& pin, const Story& story) {
    const auto leads = [&](const auto& link) { return link.pin == pin.name; };
    const auto draws = [&](const auto& figure) {
        return (figure.command + ' ').find("--pin " + pin.name + ' ') != std::string::npos;
    };
    return std::any_of(story.pins.begin(), story.pins.end(), leads) ||
           std::any_of(story.figures.begin(), story.figures.end(), draws);
}

}  // namespace

void check_lesson(const Lesson& lesson, Problems& problems) {
    const Story& english = lesson.stories.english;
    for (const Language language : languages) {
        const Story& story = lesson.stories.in(language);
        if (language != Language::english && !english.file.empty() && !story.file.empty()) {
            compare_structure(english, story, problems);
        }
        if (!lesson.runs.empty()) check_pins(lesson, story, problems);  // otherwise lesson.json could not be read
        check_lessons(lesson, story, problems);
        check_written(story, problems);
    }
    if (!lesson.runs.empty()) check_frame(lesson, problems);
    for (const Pin& pin : lesson.pins) {
        if (is_used(pin, english)) continue;
        problems.push_back({lesson.file("lesson.json"), pin.line, "pin " + pin.name + ": no story leads to it"});
    }
}

}  // namespace vidno
