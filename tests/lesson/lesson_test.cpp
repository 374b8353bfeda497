// Lessons: stories turned into blocks, pins found in runs, and messages about errors.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "lesson/event_lines.h"
#include "lesson/lesson.h"
#include "lesson/new_lesson.h"
#include "scene/scene_json.h"
#include "support/scenes.h"
#include "support/workplace.h"

using namespace vidno;
using nlohmann::json;
using Json = nlohmann::ordered_json;

namespace {

const std::string beginning = "# Title\n\n- A goal\n\n";

const std::string ending = R"(
1. Why?

   > Because.

2. And why that?

   > For the same reason.

## Summary

Enough.

## Exercises

1. How many?

   > Four.

2. And twice that?

   > Eight.
)";

Story story_of(const std::string& markdown, Problems& problems) {
    return read_story(beginning + markdown + '\n' + ending, Language::english, "story.en.md", problems);
}

/// The first block of a story without errors.
Json block_of(const std::string& markdown) {
    Problems problems;
    const Story story = story_of(markdown, problems);
    for (const auto& problem : problems) FAIL_CHECK(problem.text());
    return story.blocks[0];
}

/// The problems of a story whose fifth line begins the text.
std::string problem_of(const std::string& markdown) {
    Problems problems;
    story_of(markdown, problems);
    return problems.empty() ? "" : problems[0].text();
}

/// The story with the headings that Russian has.
std::string in_russian(std::string story) {
    return story.replace(story.find("Summary"), 7, "Итоги").replace(story.find("Exercises"), 9, "Упражнения");
}

}  // namespace

TEST_CASE("A paragraph has words, emphasis, code, and links to pins, lessons and the web") {
    CHECK(block_of("One *two* **three** `four`\nfive.") ==
          Json::parse(R"({"is": "paragraph", "text": ["One ", {"is": "emphasis", "text": ["two"]}, " ",
                          {"is": "strong", "text": ["three"]}, " ", {"is": "code", "text": "four"}, " five."]})"));
    CHECK(block_of("[the `W13` split](#split)")["text"] ==
          Json::parse(R"([{"is": "pin", "pin": "split", "text": ["the ", {"is": "code", "text": "W13"}, " split"]}])"));
    CHECK(block_of("[clipping](../05-polygon-clip/)")["text"] ==
          Json::parse(R"([{"is": "lesson", "id": "05-polygon-clip", "text": ["clipping"]}])"));
    CHECK(block_of("[there](https://example.org/a)")["text"] ==
          Json::parse(R"([{"is": "link", "url": "https://example.org/a", "text": ["there"]}])"));
}

TEST_CASE("A formula is code between dollars, or a fence") {
    CHECK(block_of("The plane $`a_1 x * 2 = d`$, and $5 for `x`.")["text"] ==
          Json::parse(R"(["The plane ", {"is": "formula", "tex": "a_1 x * 2 = d"}, ", and $5 for ",
                          {"is": "code", "text": "x"}, "."])"));
    CHECK(block_of("```math\nz = -\\frac{a x + b y + d}{c}\n```") ==
          Json::parse(R"({"is": "formula", "tex": "z = -\\frac{a x + b y + d}{c}"})"));
}

TEST_CASE("A table has a head, columns that are set left or right, and rows") {
    CHECK(block_of("| edge | x |\n| :-- | --: |\n| `0` | 1.5 |") ==
          Json::parse(R"({"is": "table", "head": [["edge"], ["x"]], "align": ["left", "right"],
                          "rows": [[[{"is": "code", "text": "0"}], ["1.5"]]]})"));
}

TEST_CASE("A figure is a fence with a caption and the command that makes it") {
    CHECK(block_of("```figure Four windows\nvidno figure lessons/01 --pin split -o four.svg\n```") ==
          Json::parse(R"({"is": "figure", "caption": ["Four windows"],
                          "command": "vidno figure lessons/01 --pin split -o four.svg", "file": "four.svg"})"));
}

TEST_CASE("A numbered list whose items end in quotes is questions and answers, another list is a list") {
    const Json question = block_of("1. How many?\n\n   > Four.\n\nMore.");
    CHECK(question["number"] == 1);
    CHECK(question["blocks"] == Json::parse(R"([{"is": "paragraph", "text": ["How many?"]}])"));
    CHECK(question["answer"] == Json::parse(R"([{"is": "paragraph", "text": ["Four."]}])"));
    CHECK(block_of("1. First\n2. Second\n\nMore.") ==
          Json::parse(R"({"is": "list", "ordered": true, "items": [[{"is": "paragraph", "text": ["First"]}],
                                                                   [{"is": "paragraph", "text": ["Second"]}]]})"));
}

TEST_CASE("Markdown that a page cannot show is a problem with a line") {
    CHECK(problem_of("Words.\n\n<b>bold</b>") == "story.en.md:7: HTML is not shown: <b>");
    CHECK(problem_of("<div>") == "story.en.md:5: HTML is not shown");
    CHECK(problem_of("![x](x.png)") ==
          "story.en.md:5: a page cannot show this within a line; a figure has its own fence");
    CHECK(problem_of("#### Deep") == "story.en.md:5: a heading within a story is of level 2 or 3: ## or ###");
    CHECK(problem_of("[x](http://example.org)") ==
          "story.en.md:5: http://example.org: neither #PIN, ../LESSON/ nor https://");
    CHECK(problem_of("```figure Four\nvidno figure lessons/01\n```") ==
          "story.en.md:5: a figure contains one line: vidno figure ... -o NAME.svg");

    Problems problems;
    read_story("Words.\n", Language::english, "story.en.md", problems);
    std::vector<std::string> found;
    for (const auto& problem : problems) found.push_back(problem.text());
    CHECK(found ==
          std::vector<std::string>{"story.en.md:1: a story begins with its title: # Title",
                                   "story.en.md:1: the learning goals are missing: a list below the title",
                                   "story.en.md:1: at least two questions to think about are required",
                                   "story.en.md:1: the summary is missing: ## Summary",
                                   "story.en.md:1: at least two exercises with answers are required: ## Exercises"});
}

TEST_CASE("Languages may order the parts of a sentence as they like, not the blocks") {
    Problems problems;
    const auto read = [&](const std::string& text) { return story_of(text, problems); };
    compare_structure(read("[a](#a) before [b](#b)"), read("[b](#b) after [a](#a)"), problems);
    CHECK(problems.empty());

    compare_structure(read("One.\n\nTwo: [a](#a)."), read("One.\n\nTwo."), problems);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].text() == "story.en.md:9: question, where story.en.md:7 has pin a");
}

TEST_CASE("A Russian formula has a decimal comma, a space between thousands, and a semicolon between coordinates") {
    const auto differences = [](const std::string& english, const std::string& russian) {
        Problems problems;
        const Story first = story_of(english, problems);
        const std::string second = in_russian(beginning + russian + '\n' + ending);
        compare_structure(first, read_story(second, Language::russian, "story.ru.md", problems), problems);
        return problems.size();
    };
    CHECK(differences("At $`p = (0.5,\\; 3{,}000{,}000)`$.", "В $`p = (0{,}5;\\; 3\\,000\\,000)`$.") == 0);
    CHECK(differences("```math\n2.5 \\cdot 12\\,u\n```", "```math\n2{,}5 \\cdot 12\\,u\n```") == 0);
    CHECK(differences("At $`0.5`$.", "В $`0{,}6`$.") == 1);
}

TEST_CASE("The list below the title holds the learning goals") {
    Problems problems;
    const Story story = story_of("Words.", problems);
    CHECK(story.goals == Json::parse(R"([["A goal"]])"));
    CHECK(story.blocks[0]["is"] == "paragraph");
}

TEST_CASE("Below the heading of the exercises a question is an exercise, in each language by its own heading") {
    Problems problems;
    const Story english = story_of("Words.", problems);
    CHECK(english.questions == 2);
    CHECK(english.exercises == 2);
    CHECK(english.blocks.back()["is"] == "exercise");
    CHECK(english.blocks.back()["number"] == 2);
    CHECK(read_story(in_russian(beginning + ending), Language::russian, "story.ru.md", problems).exercises == 2);
    CHECK(problems.empty());
}

TEST_CASE("Without its answers a story has the questions and exercises alone") {
    Problems problems;
    Story story = story_of("Words.", problems);
    omit_answers(story.blocks);
    CHECK(story.blocks.back()["blocks"] == Json::parse(R"([{"is": "paragraph", "text": ["And twice that?"]}])"));
    CHECK(story.blocks.dump().find("answer") == std::string::npos);
}

TEST_CASE("A listing names procedures and lines of the program's listings, and may name an edition") {
    CHECK(block_of("```listing\nDepth PW7\n```") ==
          Json::parse(R"({"is": "listing", "edition": "corrected", "names": ["Depth", "PW7"]})"));
    CHECK(block_of("```listing printed\nPW7\n```")["edition"] == "printed");
    CHECK(problem_of("```listing\nPW99\n```") == "story.en.md:5: PW99: neither a procedure nor one of its lines");
    CHECK(problem_of("```listing painted\nPW7\n```") == "story.en.md:5: painted: no such edition");
}

namespace {

/// Two windows, the second of which is split. Written by hand.
const std::vector<std::string> events{R"({"e":"push","at":"W3","window":[0,0,4,4],"apl":[["A",false]]})",
                                      R"({"e":"pop","at":"W5","window":[0,0,4,4]})",
                                      R"({"e":"decide","at":"W13","case":"split"})",
                                      R"({"e":"push","at":"W13","window":[0,0,2,2]})",
                                      R"({"e":"pop","at":"W5","window":[0,0,2,2]})",
                                      R"({"e":"decide","at":"W7","case":"empty"})"};

PinSearch searched(const Pin& pin) {
    PinSearch search(pin);
    for (std::size_t i = 0; i < events.size(); ++i) search.hear(i + 1, events[i]);
    return search;
}

Pin pin_to(std::vector<json> find) {
    Pin pin;
    pin.find = std::move(find);
    return pin;
}

}  // namespace

TEST_CASE("A pin is the first event with its fields, or the first after another one") {
    const Pin decision = pin_to({{{"e", "decide"}}});
    CHECK(searched(decision).step() == 3);
    const Pin decision_of_part = pin_to({{{"e", "pop"}, {"window", {0, 0, 2, 2}}}, {{"e", "decide"}}});
    CHECK(searched(decision_of_part).step() == 6);
    const Pin at_line = pin_to({{{"at", "W13"}}, {{"at", "W13"}}});
    CHECK(searched(at_line).step() == 4);
}

TEST_CASE("A pin reports where the run contradicts it") {
    const Pin none = pin_to({{{"e", "pop"}}, {{"e", "fill"}}});
    CHECK_FALSE(searched(none).step());
    CHECK(searched(none).objection() == R"(there is no {"e":"fill"} after step 2)");

    Pin decision = pin_to({{{"e", "decide"}}});
    decision.says = {{"case", "split"}};
    CHECK(searched(decision).objection().empty());
    decision.says = {{"case", "single"}};
    CHECK(searched(decision).objection() == R"(step 3 says "split" of case, not "single")");

    Pin windows = pin_to({{{"e", "pop"}}});
    windows.times = 2;
    CHECK(searched(windows).objection().empty());
    windows.times = 3;
    CHECK(searched(windows).objection() == "there are 2, not 3");
}

namespace {

/// A lesson without errors, on a square that covers the left one of two pixels. One polygon is left in the root window,
/// so it is drawn at once: one window (W10).
struct SquareLesson {
    Workplace place;
    std::string folder = place.file("square");

    SquareLesson() {
        place.write("square/scene.json",
                    R"({"format":"vidno-scene/1","window":{"x":0,"y":0,"width":2,"height":1},"polygons":[)"
                    R"({"id":"A","color":"#ff0000","vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]}]})");
        place.write("square/lesson.json",
                    R"({"format": "vidno-lesson/1", "minutes": 20, "prerequisites": [], "sources": [],
 "runs": [{"name": "windows", "method": "warnock"}],
 "pins": {
  "one": {"find": [{"e": "decide"}], "says": {"case": "single"}},
  "all": {"find": [{"e": "pop"}], "times": 1}
 }}
)");
        for (const char* language : {"en", "ru"}) {
            std::string story = "# Square\n\n- A goal\n\n[One polygon](#one) is left in [1 window](#all).\n" + ending;
            if (language == std::string("ru")) story = in_russian(story);
            place.write(std::string("square/story.") + language + ".md", story);
        }
    }

    void edit(const std::string& name, const std::string& from, const std::string& to) const {
        std::string text = place.read("square/" + name);
        REQUIRE(text.find(from) != text.npos);
        place.write("square/" + name, text.replace(text.find(from), from.size(), to));
    }
};

AdmittedScene quads() {
    return test::SceneBuilder(test::area_16).polygon(test::far_quad).polygon(test::near_square).build();
}

}  // namespace

TEST_CASE("A lesson without errors: no messages") {
    const SquareLesson lesson;
    const auto [status, text] = program("lesson check " + lesson.folder);
    CHECK(text == "");
    CHECK(status == 0);
}

TEST_CASE("A figure's command names files relative to the folder above the lessons, for any path of the lesson") {
    const SquareLesson lesson;
    const std::string lessons = lesson.place.directory.filename().string();
    for (const char* story : {"story.en.md", "story.ru.md"}) {
        lesson.edit(story, "\n[One",
                    "\n```figure One\nvidno figure " + lessons + "/square --pin one -o one.svg\n```\n\n[One");
    }
    for (const std::string& folder : {lesson.folder, lesson.folder + "/", lesson.folder + "/."}) {
        CHECK(program("lesson check " + folder).text == "");
    }
    lesson.edit("story.en.md", "--pin one", "--pin two");
    CHECK(program("lesson check " + lesson.folder).text.find("story.en.md:5: --pin two: ") != std::string::npos);
}

TEST_CASE("Errors in a lesson are reported with file and line") {
    struct Case {
        const char *file, *from, *to, *said;
    };
    for (const Case& each : std::vector<Case>{
             {"story.en.md", "#one", "#two", "story.en.md:5: lesson.json has no pin two"},
             {"story.en.md", "1 window", "a window", "story.en.md:5: pin all counts 1, its words do not: a window"},
             {"story.en.md", "1 window", "21 windows", "story.en.md:5: pin all counts 1, its words do not: 21 windows"},
             {"story.en.md", "(#one)", "(../02-none/)", "story.en.md:5: there is no lesson 02-none"},
             {"story.en.md", "Because.", "TODO", "story.en.md:9: is still to be written:    > TODO"},
             {"story.ru.md", "[One polygon](#one)", "One", "story.ru.md:7: question, where "},
             {"lesson.json", R"("single")", R"("split")", R"(lesson.json:4: pin one: step )"},
             {"lesson.json", R"("times": 1)", R"("times": 2)", "lesson.json:5: pin all: there are 1, not 2"},
             {"lesson.json", R"([{"e": "decide"}])", "[]", "lesson.json:4: /pins/one/find: contains no event"},
             {"lesson.json", R"("says")", R"("claims")", "lesson.json:4: /pins/one/claims: unknown key"},
             {"lesson.json", R"("warnock")", R"("painter")", "lesson.json:2: /runs/0/method: painter: does not exist"},
             {"lesson.json", R"("warnock"})", R"("warnock", "kernel": "half"})",
              "lesson.json:2: /runs/0/kernel: not one of float, double, "},
             {"lesson.json", R"("pins")", R"("shows": ["queue"], "pins")",
              "lesson.json:3: /shows/0: queue: no state has such a part"},
             {"lesson.json", R"("minutes": 20,)", "", R"(lesson.json:1: the minutes in class are missing: "minutes")"},
             {"lesson.json", R"("prerequisites": [])", R"("prerequisites": ["01-none"])",
              "lesson.json:1: /prerequisites/0: there is no lesson 01-none"},
             {"lesson.json", R"("sources": [])", R"("sources": [{"key": "euclid"}])",
              "lesson.json:1: /sources/0/key: euclid: not in "},
             {"lesson.json", R"("pins")", R"("pins" "x")", "lesson.json:3: line 3, column 11: not valid JSON"},
         }) {
        CAPTURE(each.said);
        const SquareLesson lesson;
        lesson.edit(each.file, each.from, each.to);
        const auto checked = program("lesson check " + lesson.folder);
        CHECK(checked.status == 1);
        CHECK_MESSAGE(checked.text.find('/' + std::string(each.said)) != std::string::npos, checked.text);
    }
}

TEST_CASE("A lesson of another version is refused with advice") {
    const SquareLesson lesson;
    lesson.edit("lesson.json", "vidno-lesson/1", "vidno-lesson/2");
    for (const std::string command : {"lesson check ", "lesson pin --step 1 ", "figure --pin one -o a.svg "}) {
        const auto refused = program(command + lesson.folder);
        CHECK(refused.status == 2);
        const std::string advice = "not \"vidno-lesson/1\" but \"vidno-lesson/2\": a newer vidno reads this file";
        CHECK_MESSAGE(refused.text.find(advice) != std::string::npos, refused.text);
    }
}

TEST_CASE("A lesson with a run of curves is checked and built, and another kernel or method is refused") {
    const SquareLesson lesson;
    lesson.place.write("square/scene.json",
                       R"({"format":"vidno-surface/1","window":{"x":0,"y":0,"width":3,"height":4},)"
                       R"("curves":[[[0,2],[2,2]],[[0,1],[2,1]]]})");
    lesson.edit("lesson.json", R"("warnock")", R"("floating-horizon")");
    // The first step of the second curve is above the first one; there are two curves.
    lesson.edit("lesson.json", R"([{"e": "decide"}], "says": {"case": "single"})",
                R"([{"e": "curve", "curve": 1}, {"e": "visibility"}], "says": {"flag": 1})");
    lesson.edit("lesson.json", R"([{"e": "pop"}], "times": 1)", R"([{"e": "curve"}], "times": 2)");
    for (const char* story : {"story.en.md", "story.ru.md"}) lesson.edit(story, "1 window", "2 curves");
    CHECK(program("lesson check " + lesson.folder).text == "");
    CHECK(program("lesson build " + lesson.folder + " -o " + lesson.place.file("course")).status == 0);
    const json trace = json::parse(lesson.place.read("course/index.json"))[0]["traces"][0];
    CHECK(trace["method"] == "floating-horizon");
    CHECK(lesson.place.has("course/" + trace["file"].get<std::string>()));

    lesson.edit("lesson.json", R"("floating-horizon")", R"("floating-horizon", "kernel": "grid")");
    CHECK(program("lesson check " + lesson.folder).text.find("grid does not run this method in this edition") !=
          std::string::npos);
    lesson.edit("lesson.json", R"("floating-horizon", "kernel": "grid")", R"("zbuffer")");
    CHECK_MESSAGE(program("lesson check " + lesson.folder).status == 2, "no scene of polygons");
}

TEST_CASE("A scene that the method of a run does not take is refused") {
    const SquareLesson lesson;
    lesson.edit("lesson.json", R"("warnock"})", R"("warnock-bodies"})");
    const auto [status, text] = program("lesson check " + lesson.folder);
    CHECK(status == 2);
    CHECK(text.find("scene.json: not for warnock-bodies: polygon A has an edge") != text.npos);
}

TEST_CASE("A pin without a link in a story is a problem") {
    const SquareLesson lesson;
    lesson.edit("lesson.json", R"("all":)", R"("idle": {"find": [{"e": "push"}]}, "all":)");
    CHECK(program("lesson check " + lesson.folder).text.find("lesson.json:5: pin idle: no story leads to it") !=
          std::string::npos);
}

TEST_CASE("A course is built from lessons: traces, steps of the pins, an index") {
    const SquareLesson lesson;
    CHECK(program("lesson build " + lesson.folder + " -o " + lesson.place.file("course")).status == 0);
    const json index = json::parse(lesson.place.read("course/index.json"));
    CHECK(index == json::parse(R"([{"id": "square", "title": {"en": "Square", "ru": "Square"},
        "traces": [{"file": "square.warnock.double.corrected.signs.jsonl.gz", "method": "warnock", "kernel": "double",
                    "edition": "corrected", "detail": "signs"}],
        "story": "square.lesson.json"}])"));
    CHECK(lesson.place.has("course/square.warnock.double.corrected.signs.jsonl.gz"));
    const json built = json::parse(lesson.place.read("course/square.lesson.json"));
    // plane, call, push of the root, pop: the window is examined at once.
    CHECK(built["pins"]["all"]["step"] == 3);
    CHECK(built["story"]["ru"]["title"] == json::parse(R"(["Square"])"));
}

TEST_CASE("A run has the title of its lesson, or the name of its scene") {
    const auto title = [](const SquareLesson& lesson) {
        CHECK(program("lesson build " + lesson.folder + " -o " + lesson.place.file("course")).status == 0);
        return json::parse(lesson.place.read("course/index.json"))[0]["traces"][0]["title"];
    };
    const SquareLesson lesson;
    lesson.edit("scene.json", R"("window")", R"("name":"One square","window")");
    CHECK(title(lesson) == json::parse(R"({"en": "One square", "ru": "One square"})"));
    lesson.edit("lesson.json", R"("warnock")", R"("warnock", "title": {"en": "A square", "ru": "Квадрат"})");
    CHECK(title(lesson) == json::parse(R"({"en": "A square", "ru": "Квадрат"})"));
}

TEST_CASE("A lesson says which parts of the state stand beside its text") {
    const SquareLesson lesson;
    lesson.edit("lesson.json", R"("pins")", R"("shows": ["stack", "active-polygons"], "pins")");
    CHECK(program("lesson build " + lesson.folder + " -o " + lesson.place.file("course")).status == 0);
    const json built = json::parse(lesson.place.read("course/square.lesson.json"));
    CHECK(built["shows"] == json::parse(R"(["stack", "active-polygons"])"));
}

TEST_CASE("A lesson requires lessons that come before it, and takes its sources from the list beside it") {
    const SquareLesson lesson;
    const auto titled = [&](const std::string& id) {
        lesson.place.write(id + "/lesson.json", "");
        for (const char* language : {"en", "ru"}) {
            lesson.place.write(id + "/story." + language + ".md", "# Before: " + id);
        }
    };
    titled("circle");
    titled("triangle");
    lesson.place.write("sources.json", R"({"euclid": {"authors": "Euclid", "title": "Elements"}})");
    lesson.edit("lesson.json", R"("prerequisites": [], "sources": [])",
                R"("prerequisites": ["circle"], "sources": [{"key": "euclid", "chapter": "4"}])");
    CHECK(program("lesson check " + lesson.folder).text == "");
    CHECK(program("lesson build " + lesson.folder + " -o " + lesson.place.file("course")).status == 0);
    const json built = json::parse(lesson.place.read("course/square.lesson.json"));
    CHECK(built["minutes"] == 20);
    CHECK(built["prerequisites"] ==
          json::parse(R"([{"id": "circle", "title": {"en": "Before: circle", "ru": "Before: circle"}}])"));
    CHECK(built["sources"] == json::parse(R"([{"authors": "Euclid", "title": "Elements", "chapter": "4"}])"));
    CHECK(built["story"]["en"]["goals"] == json::parse(R"([["A goal"]])"));

    lesson.edit("lesson.json", R"(["circle"])", R"(["triangle"])");
    CHECK(program("lesson check " + lesson.folder).text.find("triangle does not come before this lesson") !=
          std::string::npos);
}

TEST_CASE("A course or a page can be built without the answers") {
    const SquareLesson lesson;
    CHECK(program("lesson build " + lesson.folder + " -o " + lesson.place.file("course")).status == 0);
    CHECK(lesson.place.read("course/square.lesson.json").find("Eight.") != std::string::npos);
    CHECK(program("lesson build --no-answers " + lesson.folder + " -o " + lesson.place.file("course")).status == 0);
    const std::string built = lesson.place.read("course/square.lesson.json");
    CHECK(built.find("And twice that?") != std::string::npos);
    CHECK(built.find("Eight.") == std::string::npos);
}

TEST_CASE("A new lesson on a scene, a mesh or a surface lacks only its text") {
    const Workplace place;
    const std::string scene = place.write("s.json", scene_json(quads()));
    const std::string lessons = VIDNO_ROOT "/lessons/";
    for (const std::string& source : {scene, lessons + "meshes/teapot.obj", lessons + "surfaces/waves-and-pit.json"}) {
        CAPTURE(source);
        const std::string folder = place.file("new");
        CHECK(program("lesson new '" + source + "' -o " + folder).status == 0);
        const auto [status, text] = program("lesson check " + folder);
        CHECK(status == 1);
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) CHECK(line.find("is still to be written") != line.npos);

        for (const char* story : {"new/story.en.md", "new/story.ru.md"}) {
            std::string words = place.read(story);
            for (auto at = words.find("TODO"); at != words.npos; at = words.find("TODO")) words.replace(at, 4, "Said");
            place.write(story, words);
        }
        CHECK(program("lesson check " + folder).text == "");
        std::filesystem::remove_all(folder);
    }
    CHECK(program("lesson new '" + scene + "' -o " + place.directory.string()).status == 2);
}

namespace {

/// Two lines that cross between columns, below and above a horizon; the second begins farther to the right.
Surface crossing_lines() {
    const Curve near{{{0, 8}, {10, 6}, {20, 8}}};
    const Curve far{{{3, 13}, {12, 4}, {23, 15}}};
    return {"", admit(CurveScene{{0, 0, 24, 16}, {near, far}})};
}

}  // namespace

TEST_CASE("Every step of a run can be pinned") {
    const std::vector<std::pair<std::string, AnyScene>> runs{
        {"warnock", quads()}, {"zbuffer", quads()}, {"floating-horizon", crossing_lines()}};
    for (const auto& method_and_scene : runs) {
        const std::string& method = method_and_scene.first;
        const AnyScene& scene = method_and_scene.second;
        CAPTURE(method);
        LessonRun run;
        run.method = method;
        std::vector<std::string> reported;
        EventLines lines;
        trace_run(scene, run, [&](std::string_view text) {
            lines.take(text, [&](std::uint64_t, std::string_view line) { reported.emplace_back(line); });
        });
        REQUIRE(reported.size() > 200);
        for (std::uint64_t step = 1; step <= reported.size(); step += 17 * test::thinning) {
            const json written = json::parse(pin_of_step(scene, run, step));
            const Pin pin = pin_to(written["find"].get<std::vector<json>>());
            PinSearch search(pin);
            for (std::size_t i = 0; i < reported.size(); ++i) search.hear(i + 1, reported[i]);
            CHECK_MESSAGE(search.step() == step, written.dump());
        }
    }
}

namespace {

std::set<std::string> folders_of_the_course() {
    std::set<std::string> folders;
    for (const auto& entry : std::filesystem::directory_iterator(VIDNO_ROOT "/lessons")) {
        if (std::filesystem::exists(entry.path() / "lesson.json")) folders.insert(entry.path().string());
    }
    CHECK(folders.size() >= 15);
    return folders;
}

}  // namespace

TEST_CASE("The lessons agree with their runs, in both languages" * doctest::skip(test::sanitized)) {
    for (const auto& folder : folders_of_the_course()) {
        CHECK_MESSAGE(program("lesson check " + folder).text == "", folder);
    }
}

TEST_CASE("The camera of the first lesson puts the corners of its mesh where the lesson computes them") {
    const std::string folder = VIDNO_ROOT "/lessons/00-world-to-screen/";
    const Workplace place;
    const std::string camera = "--eye 0 2 8 --target 0 2 0 --fov 90 --near 2 --far 6 --width 16 --height 16";
    REQUIRE(program("import " + folder + "ramp.obj " + camera + " -o " + place.file("ramp.json")).status == 0);
    const json found = json::parse(place.read("ramp.json"))["polygons"];
    const json computed = json::parse(text_of(folder + "scene.json"))["polygons"];
    REQUIRE(found.size() == computed.size());
    for (std::size_t i = 0; i < computed.size(); ++i) {
        for (const auto& corner : computed[i]["vertices"].get<std::vector<std::array<double, 3>>>()) {
            CAPTURE(corner[0]);
            CAPTURE(corner[1]);
            // tan 45 degrees is rounded, so that a corner on a side of the view volume may be cut in two.
            const auto vertices = found[i]["vertices"].get<std::vector<std::array<double, 3>>>();
            CHECK(std::any_of(vertices.begin(), vertices.end(), [&](const auto& vertex) {
                return std::abs(vertex[0] - corner[0]) < 1e-12 && std::abs(vertex[1] - corner[1]) < 1e-12 &&
                       std::abs(vertex[2] - corner[2]) < 1e-12;
            }));
        }
    }
}

TEST_CASE("The wrong columns that the lesson on the floating horizon counts are those that check finds" *
          doctest::skip(test::sanitized)) {
    const std::string lessons = VIDNO_ROOT "/lessons/", folder = lessons + "15-floating-horizon/";
    const auto wrong_columns = [](const std::string& scene, const std::string& edition) {
        const std::string text = program("check " + scene + " --edition " + edition).text;
        const std::string before = "wrong columns of curves: ";
        const auto at = text.find(before);
        REQUIRE_MESSAGE(at != text.npos, text);
        return std::stoi(text.substr(at + before.size()));
    };
    for (const std::string story : {"story.en.md", "story.ru.md"}) {
        CAPTURE(story);
        std::istringstream lines(text_of(folder + story));
        const std::regex row(R"(\| `(printed[^`]*)` \|.*\| (\d+) \| (\d+) \|)");
        std::smatch cells;
        int rows = 0;
        for (std::string line; std::getline(lines, line);) {
            if (!std::regex_match(line, cells, row)) continue;
            CAPTURE(line);
            ++rows;
            CHECK(std::stoi(cells[2]) == wrong_columns(folder + "scene.json", cells[1]));
            CHECK(std::stoi(cells[3]) == wrong_columns(lessons + "surfaces/waves-and-pit.json", cells[1]));
        }
        CHECK_MESSAGE(rows == 8, "six errors alone, two together, all six");
    }
}

TEST_CASE("No lesson starts with a run of more than 2,000 steps") {
    for (const auto& folder : folders_of_the_course()) {
        Problems problems;
        const Lesson lesson = read_lesson(folder, problems);
        const LessonRun& first = lesson.runs.front();
        std::uint64_t steps = 0;
        EventLines lines;
        trace_run(scene_of(lesson, first), first, [&](std::string_view text) {
            lines.take(text, [&](std::uint64_t step, std::string_view) { steps = step; });
        });
        CAPTURE(lesson.id);
        CHECK(steps > 0);
        CHECK(steps <= 2000);
    }
}
