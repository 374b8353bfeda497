// The program as its users call it: its output, its exit status, and that it creates no file when it refuses.

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/workplace.h"

namespace {

namespace fs = std::filesystem;

const std::string square_scene = R"({"format":"vidno-scene/1","window":{"x":0,"y":0,"width":2,"height":1},"polygons":[)"
                                 R"({"color":"#ff0000","vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]}]})";

/// As RFC 4648 has it.
std::string base64_of(const std::string& bytes) {
    constexpr auto* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t j = i; j < i + 3; ++j) group = group << 8 | (j < bytes.size() ? (unsigned char)bytes[j] : 0u);
        for (int part = 0; part < 4; ++part) text += letters[group >> (18 - 6 * part) & 63];
    }
    for (std::size_t i = 0; i < (3 - bytes.size() % 3) % 3; ++i) text[text.size() - 1 - i] = '=';
    return text;
}

// The left pixel red, the right one background.
const std::string square_picture("P6\n2 1\n255\n\xff\0\0\xff\xff\xff", 17);

}  // namespace

TEST_CASE("render writes the picture, replay rebuilds it, at any level and both ways of storing") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    for (const std::string method : {"warnock", "zbuffer"}) {
        CHECK(program("render " + scene + " --method " + method + " -o " + work.file("a.ppm")).status == 0);
        CHECK(work.read("a.ppm") == square_picture);
        for (const std::string detail : {"windows", "polygons", "signs"}) {
            for (const std::string name : {"run.jsonl", "run.jsonl.gz"}) {
                const std::string trace = work.file(name);
                CHECK(
                    program("trace " + scene + " --method " + method + " --detail " + detail + " -o " + trace).status ==
                    0);
                CHECK(program("replay " + trace + " -o " + work.file("b.ppm")).status == 0);
                CHECK(work.read("b.ppm") == square_picture);
            }
        }
    }
}

TEST_CASE("replay --step stops there: before the first event there is only background") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    const std::string trace = work.file("run.jsonl");
    REQUIRE(program("trace " + scene + " -o " + trace).status == 0);
    CHECK(program("replay " + trace + " --step 0 -o " + work.file("a.ppm")).status == 0);
    CHECK(work.read("a.ppm") == std::string("P6\n2 1\n255\n\xff\xff\xff\xff\xff\xff", 17));
    const auto beyond = program("replay " + trace + " --step 100000 -o " + work.file("b.ppm"));
    CHECK(beyond.status == 2);
    CHECK(beyond.text.find("there is no step 100000") != std::string::npos);
    CHECK_FALSE(work.has("b.ppm"));
}

TEST_CASE("say: what happens at each step, or at some, in a language") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene), trace = work.file("run.jsonl.gz");
    REQUIRE(program("trace " + scene + " --detail windows -o " + trace).status == 0);
    // The window around the area is 2 x 2, and half of it lies in the area. The polygon is named by its place.
    const auto all = program("say " + trace);
    CHECK(all.status == 0);
    CHECK(all.text ==
          "1: The first window, (0, 0) 2 × 2, goes on the stack with 0.\n"
          "2: The window (0, 0) 2 × 2 comes off the stack.\n"
          "3: Only 0 is left in the window: background first, then 0.\n"
          "4: 2 pixels take the background.\n"
          "5: 1 pixel takes the colour of 0 in 1 row.\n"
          "Finished: 2 pixels, all as in exact arithmetic; 1 window.\n");
    CHECK(program("say " + trace + " --step 4").text == "4: 2 pixels take the background.\n");
    CHECK(program("say " + trace + " --steps 4..5 --language ru").text ==
          "4: 2 пикселя получают цвет фона.\n5: 1 пиксель получает цвет 0 в 1 строке.\n");

    for (const std::string wrong : {"--step 6", "--step 0", "--steps 2", "--steps 3..2", "--steps 1..9"}) {
        const auto refused = program("say " + trace + ' ' + wrong);
        CHECK_MESSAGE(refused.status == 2, wrong);
    }
    REQUIRE(program("trace " + scene + " --max-events 5 -o " + work.file("few.jsonl")).status == 1);
    const auto partial = program("say " + work.file("few.jsonl"));
    CHECK(partial.status == 1);
    CHECK(partial.text.find("partial") != std::string::npos);
}

TEST_CASE("say --pixel: the steps that concern a pixel, and why it has its colour") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene), trace = work.file("run.jsonl");
    REQUIRE(program("trace " + scene + " --detail windows -o " + trace).status == 0);
    const std::string shared =
        "1: · The first window, (0, 0) 2 × 2, goes on the stack with 0.\n"
        "2: · The window (0, 0) 2 × 2 comes off the stack.\n"
        "3: · Only 0 is left in the window: background first, then 0.\n"
        "4: ■ 2 pixels take the background.\n";
    CHECK(program("say " + trace + " --pixel 0,0").text ==
          shared +
              "5: ■ 1 pixel takes the colour of 0 in 1 row.\n"
              "Why it has this colour: 0 is alone in this window and covers the centre of the pixel.\n");
    CHECK(
        program("say " + trace + " --pixel 1,0").text ==
        shared +
            "5: ✗ 0 does not cover the centre of this pixel, which stays as it is.\n"
            "Why it is background: as this run computes it, the only polygon in this window does not cover the centre "
            "of the pixel.\n");
    for (const std::string wrong : {"2,0", "0", "0,0,0", "a,b", "0,0 --step 1"}) {
        CHECK_MESSAGE(program("say " + trace + " --pixel " + wrong).status == 2, wrong);
    }
}

TEST_CASE("diff: the step at which two traces diverge") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    REQUIRE(program("trace " + scene + " --kernel double -o " + work.file("a.jsonl")).status == 0);
    REQUIRE(program("trace " + scene + " --kernel double -o " + work.file("b.jsonl.gz")).status == 0);
    REQUIRE(program("trace " + scene + " --kernel exact -o " + work.file("c.jsonl")).status == 0);
    CHECK(program("diff " + work.file("a.jsonl") + " " + work.file("b.jsonl.gz")).status == 0);
    const auto difference = program("diff " + work.file("a.jsonl") + " " + work.file("c.jsonl"));
    CHECK(difference.status == 1);
    // The first event is the plane, whose numbers `exact` writes as fractions: c is twice the area of the unit square.
    CHECK(difference.text.find("differ from step 1 on\n") != std::string::npos);
    CHECK(difference.text.find("\"2/1\"") != std::string::npos);
}

TEST_CASE("A trace that was cut short, is partial or has a wrong hash: exit 1") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    REQUIRE(program("trace " + scene + " -o " + work.file("run.jsonl")).status == 0);
    const std::string whole = work.read("run.jsonl");

    SUBCASE("cut in the middle of a line") {
        const auto cut = program("replay " + work.write("cut.jsonl", whole.substr(0, whole.size() - 120)) + " -o " +
                                 work.file("a.ppm"));
        CHECK(cut.status == 1);
        CHECK(cut.text.find("cut short") != std::string::npos);
        CHECK_MESSAGE(work.has("a.ppm"), "what was read is used");
    }
    SUBCASE("a picture of another hash") {
        std::string other = whole;
        const auto digit = other.find("sha256:") + 7;
        other[digit] = other[digit] == '0' ? '1' : '0';
        const auto lie = program("replay " + work.write("lie.jsonl", other) + " -o " + work.file("a.ppm"));
        CHECK(lie.status == 1);
        CHECK(lie.text.find("do not paint the picture") != std::string::npos);
    }
    SUBCASE("stopped by --max-events") {
        const auto stopped = program("trace " + scene + " --max-events 5 -o " + work.file("few.jsonl"));
        CHECK(stopped.status == 1);
        CHECK(stopped.text.find("stopped after 5 events") != std::string::npos);
        const auto partial = program("replay " + work.file("few.jsonl") + " -o " + work.file("a.ppm"));
        CHECK(partial.status == 1);
        CHECK(partial.text.find("partial") != std::string::npos);
    }
}

TEST_CASE("Broken traces are refused with the line and the reason") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    REQUIRE(program("trace " + scene + " -o " + work.file("run.jsonl")).status == 0);
    const std::string whole = work.read("run.jsonl");
    const std::string header = whole.substr(0, whole.find('\n') + 1);
    const std::string push = R"({"e":"push","at":"W3","window":[0,0,2,2],"apl":[]})"
                             "\n";

    struct Broken {
        std::string text, reason;
    };
    const std::vector<Broken> table{
        {"", "empty, not a trace"},
        {"{}\n", ":1: /format: not a trace"},
        {"P6\n2 1\n255\n", ":1: not JSON"},
        {R"({"format":"vidno-trace/2"})"
         "\n",
         ":1: /format: not \"vidno-trace/1\" but \"vidno-trace/2\": a newer vidno reads this file"},
        {R"({"format":"vidno-trace/1","method":"painter"})"
         "\n",
         ":1: /method: unknown word"},
        {header + "[]\n", ":2: not an object"},
        {header + R"({"e":"explode","at":"W3"})"
                  "\n",
         ":2: /e: unknown event"},
        {header + R"({"e":"pop","at":"W99","window":[0,0,2,2]})"
                  "\n",
         ":2: /at: unknown word"},
        {header + R"({"e":"pop","at":"W5"})"
                  "\n",
         ":2: no key window"},
        {header + R"({"e":"pop","at":"W5","window":[0,0,2]})"
                  "\n",
         ":2: /window: not a list of 4"},
        {header + R"({"e":"pop","at":"W5","window":[0,0,2,"2"]})"
                  "\n",
         ":2: /window/3: not a number"},
        {header + R"({"e":"pop","at":"W5","window":[0,0,2,2],"more":1})"
                  "\n",
         ":2: unknown key more"},
        {header + R"({"e":"pop","at":"W5","window":[0,0,2,2]})"
                  "\n",
         ":2: step 1: the stack AW is empty"},
        {header + push +
             R"({"e":"pop","at":"W5","window":[9,9,2,2]})"
             "\n",
         ":3: step 2: not the window on top"},
        {header + R"({"e":"discard","at":"PW3","polygon":"<b>"})"
                  "\n",
         ":2: /polygon: not a polygon of the scene"},
        {header + R"({"e":"discard","at":"PW3","polygon":"0"})"
                  "\n",
         ":2: step 1: no current window"},
        {header + R"({"e":"fill","at":"W7","rect":[0,0,3,1],"color":"#ffffff"})"
                  "\n",
         ":2: step 1: a rectangle outside"},
        {header + R"({"e":"fill","at":"W7","rect":[0,0,1e99,1],"color":"#ffffff"})"
                  "\n",
         ":2: /rect/2: not a whole number"},
        {header + R"({"e":"fill","at":"W7","rect":[0,0,1,1],"color":"white"})"
                  "\n",
         ":2: /color: not a colour"},
        {header + R"({"e":"corners","at":"PW1","z":"1/2"})"
                  "\n",
         ":2: /z: not a number of this kernel"},
        {header + R"({"e":"pop","at":"PW1","window":[0,0,2,2]})"
                  "\n",
         ":2: /at: not a line of this event"},
        {header + R"({"e":"clip_side","at":"PL2","side":5,"from":[0,0],"to":[1,0]})"
                  "\n",
         ":2: /side: not from 1 to 4"},
        {header + R"({"e":"clip_list","at":"PL7","count":-1})"
                  "\n",
         ":2: /count: less than 0"},
        {header + R"({"end":{"events":7,"picture":"sha256:0"}})"
                  "\n",
         ":2: /end/events: not the number of events read"},
        {whole + "{}\n", "text after the last line"},
    };
    for (const Broken& broken : table) {
        const auto refused = program("replay " + work.write("broken.jsonl", broken.text) + " -o " + work.file("a.ppm"));
        CHECK_MESSAGE(refused.status == 2, broken.reason);
        CHECK_MESSAGE(refused.text.find(broken.reason) != std::string::npos, refused.text);
        CHECK_MESSAGE(refused.text.find('\n') == refused.text.size() - 1, "one line: " << refused.text);
        CHECK_FALSE(work.has("a.ppm"));
    }
    CHECK_MESSAGE(work.files() == 3, "no temporary file stays behind");
}

TEST_CASE("A file of another version is refused with advice by each command that reads it") {
    const Workplace work;
    const auto refused = [&](const std::string& command, const std::string& format, const std::string& out) {
        const std::string name = format.starts_with("vidno-trace") ? "other.jsonl" : "other.json";
        const std::string file = work.write(name, R"({"format":")" + format + "\"}\n");
        const auto said = program(command + ' ' + file + " -o " + work.file(out));
        CHECK(said.status == 2);
        std::string known = format;
        known.back() = '1';
        const std::string advice = "not \"" + known + "\" but \"" + format + "\": a newer vidno reads this file";
        CHECK_MESSAGE(said.text.find(advice) != std::string::npos, said.text);
    };
    for (const std::string name : {"scene", "surface", "failure"})
        refused("trace", "vidno-" + name + "/2", "run.jsonl");
    refused("replay", "vidno-trace/2", "states.jsonl");
    refused("figure", "vidno-trace/2", "figure.svg");
    refused("map", "vidno-question/2", "map.json");
    refused("figure", "vidno-chart/2", "chart.svg");
    refused("chart", "vidno-surface/2", "chart.svg");
    refused("stability --merge", "vidno-stability/2", "results.jsonl");
    const std::string results = work.write("results.jsonl", R"({"format":"vidno-stability/2"})"
                                                            "\n");
    CHECK(program("stability --count 1 -o " + results).text.find("a newer vidno reads this file") != std::string::npos);
}

TEST_CASE("The help and the README show the same scene of six lines, and it runs") {
    const Workplace work;
    std::vector<std::string> scenes;
    for (const std::string& text : {program("trace --help").text, text_of(VIDNO_ROOT "/README.md")}) {
        std::istringstream lines(text.substr(text.find(R"({"window")")));
        std::string scene;
        for (int i = 0; i < 6; ++i) {
            std::string line;
            std::getline(lines, line);
            scene += line.substr(line.find_first_not_of(' ')) + '\n';
        }
        scenes.push_back(scene);
    }
    CHECK(scenes[0] == scenes[1]);
    CHECK(std::count(scenes[0].begin(), scenes[0].end(), '\n') == 6);
    const auto traced = program("trace " + work.write("scene.json", scenes[0]) + " -o " + work.file("run.jsonl"));
    CHECK(traced.text.empty());
    CHECK(traced.status == 0);
    CHECK_MESSAGE(work.read("run.jsonl").find(R"("id":"near","color":"#0072b2")") != std::string::npos,
                  "what the file leaves out is in the trace");
}

TEST_CASE("Wrong calls are refused in one line, exit 2") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    const std::string run = work.file("run.jsonl");
    REQUIRE(program("trace " + scene + " -o " + run).status == 0);
    const std::string wide = work.write(
        "wide.json", R"({"format":"vidno-scene/1","window":{"x":0,"y":0,"width":513,"height":1},"polygons":[]})");
    const std::string decision = VIDNO_ROOT "/lessons/maps/kettner-2a.json";
    const std::string output = " -o " + work.file("out.jsonl");
    for (const std::string& call : {
             std::string(""),
             std::string("frobnicate"),
             "trace" + output,
             "trace " + scene,
             "trace " + scene + " --method painter" + output,
             "trace " + scene + " --kernel half" + output,
             "trace " + scene + " --detail all" + output,
             "trace " + scene + " --max-events -1" + output,
             "trace " + scene + " --kernel filtered --edition printed" + output,
             "trace " + scene + " --kernel filtered --edition printed:x-w2" + output,
             "trace " + scene + " --edition printed:x-z1" + output,
             "trace " + scene + " --edition printed:x-w2+x-z1" + output,
             "trace " + scene + " --edition printed:x-w10" + output,
             "trace " + scene + " --edition printed:" + output,
             "trace " + scene + " --method warnock-full --edition printed:x-w2" + output,
             "trace " + scene + " --kernel depth:16 --method warnock" + output,
             "trace " + scene + " --kernel float --edition one-list" + output,
             "trace " + scene + " --method warnock-full --edition printed" + output,
             "trace " + scene + " --method warnock-full --edition one-list" + output,
             "trace " + scene + " --method warnock-full --edition octants-not-split" + output,
             "trace " + scene + " --method warnock --edition line-for-edge" + output,
             "trace " + scene + " --method warnock-full --kernel depth:8" + output,
             "trace " + scene + " --method warnock-bodies" + output,
             "render " + scene + " --method warnock-bodies" + output + ".png",
             "check " + scene + " --method warnock-bodies",
             "shrink " + scene + " --method warnock-bodies" + output,
             "homework " + scene + " --method warnock-full -o " + work.file("a"),
             "trace " + scene + " --method zbuffer --edition one-list" + output,
             "trace " + scene + " --edition depths-not-cleared" + output,
             "trace " + work.file("missing.json") + output,
             "trace " + work.directory.string() + output,
             "trace " + scene + " -o " + work.file("no/such/place.jsonl"),
             "render " + scene + " -o " + work.file("a.gif"),
             "replay " + scene + " -o " + work.file("a.png"),
             "check " + scene + " --kernel filtered --edition printed",
             "check " + scene + " --kernel depth:16",
             "check " + work.file("missing.jsonl"),
             "diff " + scene,
             "shrink " + scene + output,
             "shrink " + scene + " --keep decision" + output,
             "shrink " + scene + " --at W13" + output,
             "shrink " + scene + " --keep decision --at Q1" + output,
             "find 'PW7 >' " + output,
             "find 'PW7 > 0 && Z16 > 0'" + output,
             "find 'PW7 > 0' --method zbuffer" + output,
             std::string("find 'PW7 > 0'"),
             "trace " + scene + " --until 'zeros > 0'" + output,
             "trace " + scene + " --until 'W5 > 1' --max-events 3" + output,
             std::string("stability --count 1 --where 'W5 > 1'"),
             std::string("need"),
             std::string("worksheet"),
             "worksheet " + scene,
             "worksheet " + scene + " -o " + work.file("a.png"),
             "worksheet " + scene + " --language la -o " + work.file("a.pdf"),
             "worksheet " + work.file("missing.json") + " -o " + work.file("a.pdf"),
             "homework " + scene,
             "homework " + scene + " --count 0 -o " + work.file("a"),
             "homework " + scene + " --seed many -o " + work.file("a"),
             "homework " + scene + " --method painter -o " + work.file("a"),
             "homework " + scene + " -o " + work.directory.string(),  // already exists
             "homework " + wide + " -o " + work.file("a"),            // has no polygons
             "homework " + work.file("missing.json") + " -o " + work.file("a"),
             "choose " + work.file("missing.json"),
             "chart " + scene,
             "chart -o " + work.file("a.json"),
             "chart " + scene + " -o " + work.file("a.tex"),
             "chart " + wide + " -o " + work.file("a.json"),
             "chart " + scene + " --cost money -o " + work.file("a.svg"),
             "chart " + work.file("missing.json") + " -o " + work.file("a.json"),
             "page " + scene,
             "page " + scene + " -o " + work.file("a.htm"),
             "page " + decision + " -o " + work.file("a.html"),
             "page " + scene + " --questions 3 -o " + work.file("a.html"),
             "page " + scene + " --questions 0 -o " + work.file("a.zip"),
             "page " + scene + " --language la -o " + work.file("a.zip"),
             "page " + work.file("missing.jsonl") + " -o " + work.file("a.html"),
             "worksheet " + scene + " -o " + work.file("a.xml"),
             "worksheet " + work.file("missing.jsonl") + " -o " + work.file("a.xml"),
             "worksheet " + work.file("missing.jsonl") + " --count 0 -o " + work.file("a.xml"),
             "worksheet " + run + " --key " + work.file("key.pdf") + " -o " + work.file("a.xml"),
             "worksheet " + run + " " + run + " -o " + work.file("a.xml"),
             "worksheet " + run + " -o " + work.file("a.pdf"),
             "worksheet " + scene + " --count 5 -o " + work.file("a.pdf"),
             "map " + scene,
             "map " + work.file("missing.json"),
             "map " + decision + " --kernel half",
             "map " + decision + " --kernel grid:4",
             "map " + decision + " -o -",
             "map " + decision + " -o " + work.file("a.gif"),
             "map " + decision + " -o " + work.file("no/such/place.png"),
             "import " + scene + " -o " + work.file("a.json"),
             std::string("stability --family cubes"),
             std::string("stability --kernel half"),
             std::string("stability --kernel depth:16"),
             std::string("stability --count 0"),
             std::string("stability --shard 3/2"),
             std::string("stability --shard 1/-1"),
             "stability --merge " + scene,
             "stability --merge " + scene + " --count 2",
             "stability -o " + scene,
         }) {
        CAPTURE(call);
        const auto refused = program(call);
        CHECK(refused.status == 2);
        CHECK(refused.text.rfind("vidno: ", 0) == 0);
        CHECK(refused.text.find('\n') == refused.text.size() - 1);
    }
    CHECK_MESSAGE(work.files() == 3, "what was there before, and nothing else");
    CHECK_MESSAGE(program("frobnicate").text.find("frobnicate") != std::string::npos, "the wrong word is named");
}

TEST_CASE("check: a table and the wrong pixels, exit 1 if anything is wrong, a trace's run as it was recorded") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    const auto right = program("check " + scene);
    CHECK(right.status == 0);
    CHECK(right.text.find("ProcessWindow") != std::string::npos);
    CHECK(right.text.find("wrong pixels: 0 of 2\n") != std::string::npos);

    // As a float the left side of the square is 1/2, and the first pixel's centre lies on it.
    const std::string drifting = work.write(
        "drifting.json",
        R"({"format":"vidno-scene/1","window":{"x":0,"y":0,"width":2,"height":1},"polygons":[)"
        R"({"color":"#ff0000","vertices":[["0x1.0000001p-1",0,0],[2,0,0],[2,1,0],["0x1.0000001p-1",1,0]]}]})");
    CHECK(program("check " + drifting).status == 0);
    const auto wrong = program("check " + drifting + " --kernel float");
    CHECK(wrong.status == 1);
    CHECK(wrong.text.find("wrong pixels: 1 of 2\n") != std::string::npos);

    const std::string trace = work.file("run.jsonl");
    REQUIRE(program("trace " + drifting + " --kernel float --check -o " + trace).status == 0);
    CHECK(work.read("run.jsonl").find(R"("e":"disagree")") != std::string::npos);
    CHECK(program("check " + trace).text == wrong.text);
    CHECK(program("check " + trace + " --kernel double").status == 0);
    CHECK(program("replay " + trace + " -o " + work.file("a.ppm")).status == 0);
}

// The corners of the square are pixel centres: two rows of pixels end exactly on its sides, at two ends each.
constexpr const char* square_on_pixel_centres =
    R"({"format":"vidno-scene/1","window":{"x":0,"y":0,"width":2,"height":2},"polygons":[)"
    R"({"color":"#ff0000","vertices":[[0.5,0.5,0],[1.5,0.5,0],[1.5,1.5,0],[0.5,1.5,0]]}]})";

TEST_CASE("check says one pixel centre met where it is one") {
    // On the only row, y = 1/2, the left side is at x = 1/2, a pixel's centre; the right side at 9/5 is not.
    const Workplace work;
    const std::string scene =
        work.write("scene.json", R"({"window":{"x":0,"y":0,"width":2,"height":2},"polygons":[)"
                                 R"({"vertices":[[0.5,0.2,0],[1.8,0.2,0],[1.8,0.8,0],[0.5,0.8,0]]}]})");
    const auto checked = program("check " + scene + " --method zbuffer");
    CHECK_MESSAGE(checked.text.find("1 pixel centre met (step ") != std::string::npos, checked.text);
}

TEST_CASE("check --list writes the exact zeros of a square on pixel centres as lines of JSON") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_on_pixel_centres);
    const auto checked = program("check " + scene + " --method zbuffer --list " + work.file("list.jsonl"));
    CHECK(checked.status == 0);
    CHECK(checked.text.find("exact zeros: ") != std::string::npos);
    CHECK(checked.text.find("pixel centres met") != std::string::npos);
    std::istringstream lines(work.read("list.jsonl"));
    std::string line;
    std::getline(lines, line);
    CHECK(nlohmann::json::parse(line).at("format") == "vidno-decisions/1");
    int ends_of_rows = 0;
    while (std::getline(lines, line)) {
        const auto decision = nlohmann::json::parse(line);
        CHECK(decision.at("kind") != "wrong");
        if (decision.at("kind") != "zero") continue;
        CHECK(decision.at("gap") == "0/1");
        if (decision.at("procedure") == "ShowLine" && decision.value("coincidence", "") == "on_pixel_centre")
            ++ends_of_rows;
    }
    CHECK(ends_of_rows >= 4);
}

TEST_CASE("check --list writes the same decisions as a table") {
    const Workplace work;
    const std::string check =
        "check " + work.write("scene.json", square_on_pixel_centres) + " --method zbuffer --list ";
    REQUIRE(program(check + work.file("list.jsonl")).status == 0);
    REQUIRE(program(check + work.file("list.csv")).status == 0);
    const std::string json = work.read("list.jsonl"), table = work.read("list.csv");
    CHECK(table.starts_with("kind,step,at,procedure,of,polygons,pixels,"));
    // Each of the two begins with one line that is not a decision.
    CHECK(std::count(table.begin(), table.end(), '\n') == std::count(json.begin(), json.end(), '\n'));
}

TEST_CASE("check --list refuses a file that is neither .csv nor .jsonl") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_on_pixel_centres);
    CHECK(program("check " + scene + " --list " + work.file("list.txt")).status == 2);
    CHECK_FALSE(fs::exists(work.file("list.txt")));
}

TEST_CASE("check: a constructed point more than half a pixel off is an error, and its step is printed") {
    const Workplace work;
    // The upper edge of A rises by 6 ulps from x = -5 to x = 25 and nearly lies on y = 8, the side of a window:
    // rounding decides where the two meet.
    const std::string scene = work.write(
        "scene.json",
        R"({"format":"vidno-scene/1","window":{"x":0,"y":0,"width":16,"height":16},"polygons":[)"
        R"({"color":"#0072b2","vertices":[[-5,"0x1.ffffffffffffcp+2",0],[25,"0x1.0000000000002p+3",0],[8,16,0]]},)"
        R"({"color":"#e69f00","vertices":[[0,0,0.5],[1,0,0.5],[0,1,0.5]]}]})");
    const auto checked = program("check " + scene + " --method warnock --kernel double");
    CHECK(checked.status == 1);
    CHECK(checked.text.find("by more than half a pixel, which is an error") != std::string::npos);
    CHECK(checked.text.find(", at step ") != std::string::npos);
}

// Returns the first step of a traced run of `scene` that took the sign of an orientation.
int first_orientation(const Workplace& work, const std::string& scene) {
    REQUIRE(program("trace " + scene + " --detail signs -o " + work.file("run.jsonl")).status == 0);
    std::istringstream lines(work.read("run.jsonl"));
    std::string line;
    std::getline(lines, line);
    for (int step = 1; std::getline(lines, line); ++step)
        if (line.find(R"("e":"orient")") != std::string::npos) return step;
    FAIL("the run takes no orientation");
    return 0;
}

TEST_CASE("margin tells the half-planes of a step and a vertex as text and as JSON") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    const std::string call =
        "margin " + scene + " --step " + std::to_string(first_orientation(work, scene)) + " --vertex 0.1";
    const auto text = program(call);
    CHECK(text.status == 0);
    CHECK(text.text.find("SurroundTest, vertex 0.1 at (1, 0)") != std::string::npos);
    const auto json = nlohmann::json::parse(program(call + " --json").text);
    CHECK(json.at("format") == "vidno-margin/1");
    CHECK(json.at("vertex") == 1);
    CHECK(json.at("at") == nlohmann::json({1, 0}));
}

namespace {

/// A at depth 1/8 everywhere; B at 1/4 in the left half, later in the scene; C, the small square right of the middle,
/// at -1/8; D edge-on.
const std::string four_polygons = R"({"window":{"x":0,"y":0,"width":4,"height":2},"background":"#ffffff","polygons":[
    {"id":"A","color":"#aa0000","vertices":[[-1,-1,0.125],[5,-1,0.125],[5,3,0.125],[-1,3,0.125]]},
    {"id":"B","color":"#0000bb","vertices":[[-1,-1,0.25],[2,-1,0.25],[2,3,0.25],[-1,3,0.25]]},
    {"id":"C","color":"#00cc00","vertices":[[2,0,-0.125],[3,0,-0.125],[3,1,-0.125],[2,1,-0.125]]},
    {"id":"D","color":"#dddd00","vertices":[[0,0,0],[1,1,0],[2,2,1]]}]})";
const std::string left_blue = std::string("\x00\x00\xbb\x00\x00\xbb", 6);
const std::string right_red = std::string("\xaa\x00\x00\xaa\x00\x00", 6);
const std::string ppm_header = "P6\n4 2\n255\n";

}  // namespace

TEST_CASE("why: the reasons of a pixel and the smallest changes, in both languages and as JSON") {
    const Workplace work;
    const std::string scene = work.write("scene.json", four_polygons);
    CHECK(program("why " + scene + " --pixel 1,1").text ==
          "pixel 1,1: B shows, at depth 1/4; if it sinks by 1/8, A shows; edge 1 of B passes 1/2 px to the right: if "
          "it moves left by "
          "more than that, B does not show\n"
          "  A is 1/8 farther here; it shows if it rises by 1/8\n"
          "  edge 2 of C passes 1/2 px above, edge 3 of C passes 1/2 px to the right; C shows if edge 2 moves down by "
          "1/2 px, edge 3 moves "
          "left by 1/2 px and it rises by more than 3/8\n"
          "  D is edge-on and shows nowhere\n");
    CHECK(program("why " + scene + " --pixel 1,1 --language ru").text.find("A здесь дальше на 1/8") !=
          std::string::npos);
    const auto json = nlohmann::json::parse(program("why " + scene + " --pixel 2,0 --json").text);
    CHECK(json.at("owner") == "A");
    CHECK(json.at("polygons").at(2) ==
          nlohmann::json{
              {"polygon", "C"}, {"standing", "behind"}, {"depth", "-1/8"}, {"gap", "1/4"}, {"wins_ties", false}});
    CHECK(program("why " + scene + " --pixel 4,0").status == 2);
}

TEST_CASE("why names the decision that made a run wrong at the pixel") {
    // Half an ulp decides; the entry of the atlas fails in ShowLine, which adds up rounded depths.
    const std::string failure = VIDNO_ROOT "/lessons/failures/depth-by-an-ulp.json";
    const Outcome wrong = program("why " + failure + " --pixel 0,0");
    CHECK(wrong.status == 1);
    CHECK(wrong.text.find(
              "the run paints #0072b2 where the colour must be #e69f00: the decision at step 42, L6 (ShowLine) is "
              "wrong: its operands had already drifted\n") != std::string::npos);
    const Outcome right = program("why " + failure + " --pixel 0,0 --kernel filtered");
    CHECK(right.status == 0);
    CHECK(right.text.find("the run paints") == std::string::npos);
}

TEST_CASE("prove: a right picture has a proof, and a wrong one the reason at each wrong pixel") {
    const Workplace work;
    const std::string scene = work.write("scene.json", four_polygons), proof = work.file("proof.jsonl");
    const std::string right = left_blue + right_red + left_blue + right_red;
    const std::string prove = "prove " + scene + " -o " + proof + " --picture ";
    CHECK(program(prove + work.write("right.ppm", ppm_header + right)).text.empty());
    // By hand: B ends between columns 1 and 2.
    CHECK(work.read("proof.jsonl") ==
          "{\"format\":\"vidno-proof/1\"}\n"
          "{\"rectangle\":[0,0,4,2],\"edge_on\":[3],\"behind\":[[2,0]]}\n"
          "{\"rectangle\":[0,0,2,2],\"behind\":[[0,1]],\"owner\":1}\n"
          "{\"rectangle\":[2,0,2,2],\"beside\":[[1,1]],\"owner\":0}\n");

    const Outcome wrong = program("prove " + scene + " -o " + work.file("none.jsonl") + " --picture " +
                                  work.write("wrong.ppm", ppm_header + right_red + right.substr(6)));
    CHECK(wrong.status == 1);
    CHECK(wrong.text.find("pixel 0,0 is #aa0000, but B shows, at depth 1/4;") == 0);
    CHECK(wrong.text.find(". A is 1/8 farther here; it shows if it rises by 1/8\n") != std::string::npos);
    CHECK_FALSE(work.has("none.jsonl"));
    CHECK(program(prove + work.write("small.ppm", "P6\n1 1\n255\nabc")).status == 2);
    CHECK(program(prove + work.write("text.png", "no picture")).status == 2);
}

TEST_CASE("prove --scene writes what the checkers read, and without it a scene that they do not read is said") {
    const Workplace work;
    const std::string scene = work.write("scene.json", R"({"polygons":[{"vertices":[[0,0,0],[2,0,0],[0,2,0]]}]})");
    const std::string prove = "prove " + scene + " -o " + work.file("proof.jsonl");
    CHECK(program(prove).text.find("--scene FILE") != std::string::npos);
    CHECK(program(prove + " --scene " + work.file("plain.json")).text.empty());
    const std::string plain = "prove " + work.file("plain.json") + " -o " + work.file("proof.jsonl");
    CHECK(program(plain).text.empty());
}

TEST_CASE("margin refuses a step without a sign and a vertex that the scene lacks") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    const std::string orientation = "margin " + scene + " --step " + std::to_string(first_orientation(work, scene));
    CHECK(program("margin " + scene + " --step 1 --vertex 0.1").status == 2);
    CHECK(program(orientation + " --vertex 0.4").status == 2);
    CHECK(program(orientation + " --vertex 1.0").status == 2);
}

TEST_CASE("A usual mistake runs by its name: traced, replayed, run again by check, compared with the right run") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    // Upside down the square of the only row is the same.
    CHECK(program("render " + scene + " --edition y-flipped -o " + work.file("a.ppm")).status == 0);
    CHECK(work.read("a.ppm") == square_picture);
    // Z starts at 0, and the square lies there.
    const std::string wrong = work.file("wrong.jsonl"), right = work.file("right.jsonl");
    REQUIRE(program("trace " + scene + " --method zbuffer --edition depths-not-cleared -o " + wrong).status == 0);
    REQUIRE(program("trace " + scene + " --method zbuffer -o " + right).status == 0);
    CHECK(work.read("wrong.jsonl").find(R"("edition":"depths-not-cleared")") != std::string::npos);
    CHECK(program("replay " + wrong + " -o " + work.file("b.ppm")).status == 0);
    CHECK(work.read("b.ppm") == std::string("P6\n2 1\n255\n\xff\xff\xff\xff\xff\xff", 17));
    const auto checked = program("check " + wrong);
    CHECK(checked.status == 1);
    CHECK(checked.text.find("wrong pixels: 1 of 2") != std::string::npos);
    CHECK(program("diff " + wrong + " " + right).status == 1);
    const auto refused = program("render " + scene + " --edition depths-not-cleared -o " + work.file("c.ppm"));
    CHECK(refused.text == "vidno: --edition depths-not-cleared: a mistake of --method zbuffer alone\n");
}

TEST_CASE("shrink: the result still fails, and a scene that does not fail is refused") {
    const Workplace work;
    const std::string clipped = VIDNO_ROOT "/lessons/05-polygon-clip/scene.json";
    const std::string smallest = work.file("smallest.json");
    CHECK(program("shrink " + clipped + " -o " + smallest).text == clipped + ": 1 of 2 polygons, 3 of 6 vertices\n");
    CHECK_MESSAGE(program("check " + smallest).status == 1, "it fails");
    CHECK(program("shrink " + clipped + " --keep decision --at PL5 -o " + smallest).status == 0);
    REQUIRE(program("trace " + smallest + " -o " + work.file("run.jsonl")).status == 0);
    CHECK(work.read("run.jsonl").find("\"at\":\"PL5\"") != std::string::npos);
    CHECK(program("shrink " + clipped + " --kernel filtered -o " + work.file("none.json")).text ==
          "vidno: " + clipped + ": nothing fails: no decision and no pixel is wrong\n");
    CHECK_FALSE(work.has("none.json"));
}

TEST_CASE("The Warnock family: traced, replayed, checked, and a polygon outside the domain is refused by name") {
    const Workplace work;
    const std::string scene = VIDNO_ROOT "/lessons/01-four-relations/scene.json";
    REQUIRE(program("render " + scene + " --method zbuffer --kernel exact -o " + work.file("right.ppm")).status == 0);
    for (const std::string method : {"simplest", "full", "angles", "vertex"}) {
        CAPTURE(method);
        const std::string named = " --method warnock-" + method;
        const std::string trace = work.file(method + ".jsonl"), picture = work.file(method + ".ppm");
        REQUIRE(program("trace " + scene + named + " --kernel filtered --check -o " + trace).status == 0);
        REQUIRE(program("replay " + trace + " -o " + picture).status == 0);
        CHECK(work.read(method + ".ppm") == work.read("right.ppm"));
        CHECK(program("check " + scene + named + " --kernel filtered").status == 0);
    }
    const auto refused = program("render " + scene + " --method warnock-bodies -o " + work.file("none.ppm"));
    CHECK(refused.status == 2);
    CHECK(refused.text.find("warnock-bodies takes closed convex bodies") != std::string::npos);
    CHECK(refused.text.find("has an edge that no other polygon shares") != std::string::npos);
}

TEST_CASE(
    "Weiler and Atherton's algorithm: traced, replayed, compared, checked, drawn, and its regions written to a file") {
    const Workplace work;
    const std::string scene = VIDNO_ROOT "/lessons/01-four-relations/cycle.json", named = " --method weiler-atherton";
    REQUIRE(program("render " + scene + " --method zbuffer --kernel exact -o " + work.file("right.ppm")).status == 0);
    for (const std::string kernel : {"filtered", "exact"}) {
        CAPTURE(kernel);
        const std::string trace = work.file(kernel + ".jsonl"), picture = work.file(kernel + ".ppm");
        REQUIRE(program("trace " + scene + named + " --kernel " + kernel + " --check -o " + trace).status == 0);
        REQUIRE(program("replay " + trace + " -o " + picture).status == 0);
        CHECK(work.read(kernel + ".ppm") == work.read("right.ppm"));
        CHECK(program("check " + scene + named + " --kernel " + kernel).status == 0);
    }
    CHECK(program("diff " + work.file("filtered.jsonl") + " " + work.file("filtered.jsonl")).status == 0);
    CHECK(program("diff " + work.file("filtered.jsonl") + " " + work.file("exact.jsonl")).status == 1);

    const std::string trace = work.file("run.jsonl");
    REQUIRE(program("trace " + scene + named + " --detail polygons -o " + trace).status == 0);
    for (const std::string form : {".svg", ".pdf", ".tex"}) {
        CAPTURE(form);
        const std::string parts = " --show picture,windows,list,listing -o ";
        CHECK(program("figure " + trace + " --step 60" + parts + work.file("step" + form)).status == 0);
        CHECK(program("render " + scene + named + " -o " + work.file("regions" + form)).status == 0);
        CHECK(work.has("regions" + form));
    }
    CHECK(work.read("step.svg").find("List L, C first") != std::string::npos);
    REQUIRE(program("render " + scene + named + " --kernel exact -o " + work.file("regions.json")).status == 0);
    CHECK(work.read("regions.json").find("\"format\":\"vidno-regions/1\"") != std::string::npos);

    CHECK(program("render " + scene + named + " --kernel grid:8 -o " + work.file("none.ppm")).text ==
          "vidno: --method weiler-atherton: not under --kernel grid:8\n");
    CHECK(program("render " + scene + named + " --edition printed -o " + work.file("none.ppm")).text ==
          "vidno: --method weiler-atherton: only --edition corrected\n");
    CHECK(program("render " + scene + " -o " + work.file("none.json")).status == 2);
}

TEST_CASE("need and choose: a table, and a choice with the right picture") {
    const std::string drifting = VIDNO_ROOT "/lessons/08-show-line/scene.json";
    const auto needed = program("need " + drifting);
    CHECK(needed.status == 0);
    CHECK(needed.text.find("bits of arithmetic, zbuffer     more than 53  with double pixel") != std::string::npos);
    const auto chosen = program("choose " + drifting);
    CHECK(chosen.status == 0);
    CHECK_MESSAGE(chosen.text.find("choose zbuffer under double") == std::string::npos, "it has wrong pixels");
    CHECK(chosen.text.find("agreed with all of its decisions") != std::string::npos);
}

TEST_CASE("chart: the output's name selects the format") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    REQUIRE_MESSAGE(program("chart " + scene + " -o " + work.file("a.json")).status == 1,
                    "the printed Z-buffer faults");
    CHECK(work.read("a.json").rfind("{\"format\":\"vidno-chart/1\"", 0) == 0);
    REQUIRE(program("chart " + scene + " " + scene + " -o " + work.file("a.csv")).status == 1);
    CHECK(work.read("a.csv").rfind("scene.name,", 0) == 0);
    REQUIRE(program("chart " + scene + " --cost bits --error depthUlps -o " + work.file("a.svg")).status == 1);
    const std::string figure = work.read("a.svg");
    CHECK(figure.find("<svg ") != std::string::npos);
    CHECK(figure.find("depth error, ulps") != std::string::npos);
    CHECK(figure.find("operations × bits") != std::string::npos);
    REQUIRE(program("chart " + scene + " -o " + work.file("a.pdf")).status == 1);
    CHECK(work.read("a.pdf").starts_with("%PDF"));
}

TEST_CASE("worksheet: the questions that the built script for Node makes about a trace") {
    const Workplace work;
    fs::create_directories(work.directory / "bin");
    fs::create_directories(work.directory / "share/vidno");
    fs::copy_file(VIDNO_FILE, work.directory / "bin/vidno");
    const std::string script = "share/vidno/vidno-questions.mjs";
    const std::string trace = work.file("run.jsonl");
    REQUIRE(program("trace " + work.write("scene.json", square_scene) + " -o " + trace).status == 0);
    const auto worksheet = [&](const std::string& arguments) {
        return program("worksheet " + arguments + " -o " + work.file("out.xml"), work.file("bin/vidno"));
    };

    SUBCASE("its options and the trace go in, the questions come out") {
        work.write(script, "process.stdout.write(process.argv.slice(2).join(' ')); process.stdin.pipe(process.stdout)");
        REQUIRE(worksheet(trace + " --language ru --count 5").status == 0);
        CHECK(work.read("out.xml") == "--language ru --count 5" + work.read("run.jsonl"));
        REQUIRE(worksheet(trace).status == 0);
        CHECK(work.read("out.xml") == "--language en --count 20" + work.read("run.jsonl"));
    }
    SUBCASE("a trace that is cut short: questions on the steps that it has, and status 1") {
        work.write(script, "process.stdout.write('questions')");
        const std::string whole = work.read("run.jsonl");
        const auto cut = worksheet(work.write("cut.jsonl", whole.substr(0, whole.size() - 20)));
        CHECK(cut.status == 1);
        CHECK(cut.text.find("cut.jsonl") != std::string::npos);
        CHECK(cut.text.find("cut short: ") != std::string::npos);
        CHECK(work.read("out.xml") == "questions");
    }
    SUBCASE("refused in one line: a trace without questions, and where the script was not built") {
        work.write(script, "console.error('Much to say:\\nnothing to ask about'); process.exitCode = 2");
        const auto none = worksheet(trace);
        CHECK(none.status == 2);
        CHECK(none.text == "vidno: " + trace + ": node: nothing to ask about\n");
        fs::remove(work.file(script));
        const auto unbuilt = worksheet(trace);
        CHECK(unbuilt.status == 2);
        CHECK(unbuilt.text.find("vidno-questions.mjs: not there; ./dev demo builds the page") != std::string::npos);
        CHECK_FALSE(work.has("out.xml"));
    }
}

TEST_CASE("page: the built page with the given content instead of its lessons") {
    const Workplace work;
    // The page that the program finds beside its own folder.
    const std::string before = R"(<html><script type="module">let a = '</body>'</script><body><p>page</p>)";
    const std::string library = R"(<script type="application/octet-stream" id="vidno-library">H4sI</script>)";
    const std::string after = "</body></html><!-- licences -->\n";
    const std::string lessons = R"(<script type="application/json" id="vidno-lessons">[{"id":"a"}]</script>)"
                                R"(<script type="application/octet-stream" data-vidno-file="a.jsonl.gz">H4sI</script>)"
                                R"(<script type="application/octet-stream" data-vidno-file="b.jsonl.gz">H4sI</script>)";
    fs::create_directories(work.directory / "bin");
    fs::create_directories(work.directory / "share/vidno");
    fs::copy_file(VIDNO_FILE, work.directory / "bin/vidno");
    const std::string vidno = work.file("bin/vidno");
    const auto page = [&](const std::string& arguments) { return program("page " + arguments, vidno); };

    const std::string scene = work.write("scene.json", square_scene);
    const std::string trace = work.file("run.jsonl.gz");
    REQUIRE(program("trace " + scene + " --method zbuffer -o " + trace).status == 0);
    const std::string output = " -o " + work.file("out.html");

    SUBCASE("a trace that is already compressed: its bytes as base64") {
        work.write("share/vidno/index.html", before + lessons + library + after);
        REQUIRE(page(trace + output).status == 0);
        REQUIRE(program("trace " + scene + " --method zbuffer -o " + work.file("plain.jsonl")).status == 0);
        const std::string made = work.read("out.html");
        const std::string index =
            R"([{"id":"1.jsonl.gz","title":{"en":"run.jsonl.gz","ru":"run.jsonl.gz"},"traces":[{"file":"1.jsonl.gz",)"
            R"("method":"zbuffer","kernel":"double","edition":"corrected","detail":"signs"}]}])";
        const std::string blocks = R"(<script type="application/json" id="vidno-lessons">)" + index +
                                   R"(</script><script type="application/octet-stream" data-vidno-file="1.jsonl.gz">)" +
                                   base64_of(work.read("run.jsonl.gz")) + "</script>";
        CHECK(made == before + blocks + library + after);
    }
    SUBCASE(
        "a scene, with the options of a run; no name ends the block; a page without lessons takes them at its end") {
        work.write("share/vidno/index.html", before + library + after);
        const std::string named = R"({"name":"</script><b>",)" + square_scene.substr(1);
        REQUIRE(page(work.write("named.json", named) + " " + trace + output).status == 0);
        const std::string made = work.read("out.html");
        CHECK(made.rfind(before + library + R"(<script type="application/json" id="vidno-lessons">[)", 0) == 0);
        CHECK(made.find(R"("title":{"en":"\u003c/script>\u003cb>",)") != std::string::npos);
        CHECK(made.find(
                  R"("file":"1.json","method":"warnock","kernel":"double","edition":"corrected","detail":"signs")") !=
              std::string::npos);
        // {"format" in base64: seven of its bytes in whole letters.
        CHECK(made.find(R"(data-vidno-file="1.json">eyJmb3JtYX)") != std::string::npos);
        CHECK(made.find(R"(data-vidno-file="2.jsonl.gz">)") != std::string::npos);
    }
    SUBCASE("a surface, and a trace of curves") {
        work.write("share/vidno/index.html", before + library + after);
        const std::string surface = work.write("surface.json", R"({"format":"vidno-surface/1","name":"Line",)"
                                                               R"("window":{"x":0,"y":0,"width":2,"height":2},)"
                                                               R"("curves":[[[0,1],[1,1]]]})");
        const std::string curves = work.file("curves.jsonl");
        REQUIRE(program("trace " + surface + " --kernel exact -o " + curves).status == 0);
        REQUIRE(page(surface + " " + curves + output).status == 0);
        const std::string made = work.read("out.html");
        const std::string index = R"("method":"floating-horizon","kernel":")";
        CHECK(made.find(R"("file":"1.json",)" + index + "double") != std::string::npos);
        CHECK(made.find(R"("file":"2.jsonl.gz",)" + index + "exact") != std::string::npos);
        CHECK(made.find(R"(data-vidno-file="1.json">)" + base64_of(work.read("surface.json"))) != std::string::npos);
    }
    SUBCASE("a trace of Weiler and Atherton's algorithm") {
        work.write("share/vidno/index.html", before + library + after);
        const std::string regions = work.file("regions.jsonl.gz");
        REQUIRE(program("trace " + scene + " --method weiler-atherton -o " + regions).status == 0);
        REQUIRE(page(regions + output).status == 0);
        const std::string made = work.read("out.html");
        CHECK(made.find(R"("file":"1.jsonl.gz","method":"weiler-atherton","kernel":"double")") != std::string::npos);
        CHECK(made.find(R"(data-vidno-file="1.jsonl.gz">)" + base64_of(work.read("regions.jsonl.gz"))) !=
              std::string::npos);
    }
    SUBCASE("nothing given: the page with its lessons") {
        work.write("share/vidno/index.html", before + lessons + library + after);
        REQUIRE(page(output).status == 0);
        CHECK(work.read("out.html") == before + lessons + library + after);
    }
    SUBCASE("a trace that was cut short is read as far as it goes, exit 1") {
        work.write("share/vidno/index.html", before + lessons + library + after);
        REQUIRE(program("trace " + scene + " -o " + work.file("whole.jsonl")).status == 0);
        const std::string whole = work.read("whole.jsonl");
        const auto cut = page(work.write("cut.jsonl", whole.substr(0, whole.size() - 120)) + output);
        CHECK(cut.status == 1);
        CHECK(cut.text.find("cut short") != std::string::npos);
        CHECK(work.has("out.html"));
    }
    SUBCASE("refused: what is neither, a scene for a page that cannot run one, and where no page was built") {
        const std::string text = work.write("text.jsonl", "hello\n");
        work.write("share/vidno/index.html", before + lessons + after);
        CHECK(page(text + output).text.find("text.jsonl:1: not JSON") != std::string::npos);
        CHECK(page(scene + output).text.find("without the library") != std::string::npos);
        CHECK(page(trace + output).status == 0);
        fs::remove(work.file("out.html"));
        fs::remove(work.file("share/vidno/index.html"));
        const auto unbuilt = page(trace + output);
        CHECK(unbuilt.status == 2);
        CHECK(unbuilt.text.find("index.html: not there; ./dev demo builds the page") != std::string::npos);
        CHECK_FALSE(work.has("out.html"));
    }
    SUBCASE("a language: that of the address at which the page opens") {
        work.write("share/vidno/index.html", before + lessons + library + after);
        REQUIRE(page("--language ru" + output).status == 0);
        const std::string address = R"(<script type="application/json" id="vidno-address">"#lang=ru"</script>)";
        CHECK(work.read("out.html") == before + lessons + library + address + after);
    }

    const auto in_package = [&](const std::string& file) {
        const auto unpacked = program("-p " + work.file("out.zip") + " " + file, "unzip");
        CHECK_MESSAGE(unpacked.status == 0, unpacked.text);
        return unpacked.text;
    };
    const auto titles = [&] {
        std::vector<std::string> found;
        std::istringstream lines(in_package("imsmanifest.xml"));
        for (std::string line; std::getline(lines, line);) {
            const auto begin = line.find("<title>");
            if (begin == line.npos) continue;
            found.push_back(line.substr(begin + 7, line.find("</title>") - begin - 7));
        }
        REQUIRE(found.size() == 2);
        CHECK_MESSAGE(found[0] == found[1], "of the organization, and of its only item");
        return found[0];
    };
    const std::string package = " -o " + work.file("out.zip");
    SUBCASE("a package: a manifest and the page, the same bytes each time") {
        work.write("share/vidno/index.html", before + library + after);
        REQUIRE(page(scene + output).status == 0);
        REQUIRE(page(scene + package).status == 0);
        CHECK(program("-t " + work.file("out.zip"), "unzip").status == 0);
        CHECK(program("-Z1 " + work.file("out.zip"), "unzip").text == "imsmanifest.xml\nindex.html\n");
        CHECK(in_package("index.html") == work.read("out.html"));
        const std::string first = work.read("out.zip");
        REQUIRE(page(scene + package).status == 0);
        CHECK(work.read("out.zip") == first);
    }
    SUBCASE("a package is completed by five questions, or by as many as are requested") {
        work.write("share/vidno/index.html", before + library + after);
        REQUIRE(page(scene + package).status == 0);
        CHECK(in_package("imsmanifest.xml").find("<adlcp:datafromlms>5</adlcp:datafromlms>") != std::string::npos);
        REQUIRE(page(scene + " --questions 8" + package).status == 0);
        CHECK(in_package("imsmanifest.xml").find("<adlcp:datafromlms>8</adlcp:datafromlms>") != std::string::npos);
    }
    SUBCASE("a package has the title of its content: in the language, of the first and the last, or of the program") {
        work.write("share/vidno/index.html", before + library + after);
        REQUIRE(page(VIDNO_ROOT "/lessons/02-corner-depths --language ru" + package).status == 0);
        CHECK(titles() == "Глубины в углах: достаточно, но не необходимо");
        REQUIRE(page(VIDNO_ROOT "/lessons/02-corner-depths " + trace + " " + scene + package).status == 0);
        CHECK(titles() == "The corner depths: sufficient, not necessary \u2013 scene.json");
        REQUIRE(page(package).status == 0);
        CHECK(titles() == "vidno");
    }
    SUBCASE("a title in a manifest is plain text of at most 200 characters") {
        work.write("share/vidno/index.html", before + library + after);
        const auto named = [&](const std::string& name) {
            return work.write("named.json", R"({"name":")" + name + "\"," + square_scene.substr(1));
        };
        REQUIRE(page(named("</title>&\\u0001") + package).status == 0);
        CHECK(titles() == "&lt;/title&gt;&amp;\ufffd");
        std::string name;
        for (int i = 0; i < 100; ++i) name += "аб";
        REQUIRE(page(named(name) + package).status == 0);
        CHECK(titles() == name);
        REQUIRE(page(named(name + "в") + package).status == 0);
        CHECK(titles() == name.substr(0, name.size() - 2) + "\u2026");
    }
}

TEST_CASE("map: a table, a picture or counts, exit 1 if any place is answered wrongly") {
    const Workplace work;
    const std::string decision = VIDNO_ROOT "/lessons/maps/kettner-2a.json";
    const auto wrong = program("map " + decision + " -o " + work.file("a.png"));
    CHECK(wrong.status == 1);
    CHECK(wrong.text.find("orientation under double\ncomputed        exactly negative") == 0);
    CHECK(work.read("a.png").find("PNG") == 1);
    const auto right = program("map " + decision + " --kernel filtered -o " + work.file("b.ppm"));
    CHECK(right.status == 0);
    CHECK(right.text.find("\ndiffer: 0 of 65536\n") != std::string::npos);
    CHECK(work.read("b.ppm").find("P6\n1024 1024\n255\n") == 0);
    CHECK(program("map " + decision + " --kernel exact -o " + work.file("c.json")).status == 0);
    CHECK(work.read("c.json").find(R"("differ":0)") != std::string::npos);
    CHECK_MESSAGE(program("map " + decision).text == wrong.text, "without a file the table alone");
}

TEST_CASE("figure: the output's name selects the format, and the bytes are the same each time") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    const std::string run = work.file("run.jsonl");
    REQUIRE(program("trace " + scene + " -o " + run).status == 0);
    const std::vector<std::pair<std::string, std::string>> beginnings{
        {".svg", "<?xml"}, {".pdf", "%PDF"}, {".png", "\x89PNG"}, {".tex", "% "}};
    for (const auto& [extension, beginning] : beginnings) {
        for (const std::string name : {"a", "b"}) {
            const auto drawn =
                program("figure " + run + " --show picture,windows,list,listing -o " + work.file(name + extension));
            CHECK_MESSAGE(drawn.status == 0, drawn.text);
        }
        CHECK(work.read("a" + extension).rfind(beginning, 0) == 0);
        CHECK(work.read("a" + extension) == work.read("b" + extension));
    }
    CHECK(program("figure " + run + " --steps 0..4:2 --beamer -o " + work.file("slide.tex")).status == 0);
    CHECK(work.read("slide.tex").find("\\only<3>") != std::string::npos);
    const std::string maps = VIDNO_ROOT "/lessons/maps/";
    CHECK(program("figure " + maps + "surround.json --language ru -o " + work.file("map.svg")).status == 0);
    for (const auto* word : {"охват", "снаружи", "Вершина треугольника"})
        CHECK(work.read("map.svg").find(word) != std::string::npos);
    REQUIRE(program("chart " + scene + " -o " + work.file("chart.json")).status == 1);
    CHECK(program("figure " + work.file("chart.json") + " --width 10cm -o " + work.file("chart.svg")).status == 0);
    CHECK(work.read("chart.svg").find("width=\"100mm\"") != std::string::npos);
}

TEST_CASE("figure: an impossible figure is refused in one line, and no file appears") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    const std::string decision = VIDNO_ROOT "/lessons/maps/kettner-2a.json";
    const std::string run = work.file("run.jsonl");
    REQUIRE(program("trace " + scene + " --detail windows -o " + run).status == 0);
    for (const std::string& call : {
             "figure " + run + " -o " + work.file("a.gif"),
             "figure " + run + " --step 100000 -o " + work.file("a.svg"),
             "figure " + run + " --steps 3..2 -o " + work.file("a.svg"),
             "figure " + run + " --steps 2,1 -o " + work.file("a.svg"),
             "figure " + run + " --steps 1..9:0 -o " + work.file("a.svg"),
             "figure " + run + " --step 1 --steps 1,2 -o " + work.file("a.svg"),
             "figure " + run + " --show picture,sound -o " + work.file("a.svg"),
             "figure " + run + " --show history -o " + work.file("a.svg"),
             "figure " + run + " --show history --pixel 9,9 -o " + work.file("a.svg"),
             "figure " + run + " --show list -o " + work.file("a.svg"),  // of level windows
             "figure " + run + " --width 8 -o " + work.file("a.svg"),
             "figure " + run + " --width 8km -o " + work.file("a.svg"),
             "figure " + run + " --language la -o " + work.file("a.svg"),
             "figure " + run + " --beamer -o " + work.file("a.svg"),
             "figure " + decision + " --step 1 -o " + work.file("a.svg"),
             "figure " + decision + " -o " + work.file("a.tex"),
             "figure " + scene + " -o " + work.file("a.svg"),
             "figure " + work.file("missing.jsonl") + " -o " + work.file("a.svg"),
         }) {
        CAPTURE(call);
        const auto refused = program(call);
        CHECK(refused.status == 2);
        CHECK(refused.text.rfind("vidno: ", 0) == 0);
        CHECK(refused.text.find('\n') == refused.text.size() - 1);
    }
    CHECK(work.files() == 2);
    CHECK(program("figure " + run + " --show list -o " + work.file("a.svg")).text.find("no APL") != std::string::npos);
}

TEST_CASE("Help lists the commands, exit 0") {
    for (const std::string call :
         {"--help", "trace --help", "check --help", "shrink --help", "find --help", "find --list", "need --help",
          "choose --help", "chart --help", "page --help", "map --help", "say --help", "figure --help",
          "stability --help", "homework --help", "worksheet --help", "import --help", "methods", "--version"}) {
        CHECK(program(call).status == 0);
        CHECK(program(call).text.size() > 10);
    }
    CHECK(program("methods").text.find("nearest polygon at each pixel centre") != std::string::npos);
    CHECK(program("methods").text.find("domain: closed convex bodies") != std::string::npos);
}

TEST_CASE("methods --json: which edition of which method runs under which kernel") {
    const auto said = program("methods --json");
    CHECK(said.status == 0);
    const auto choices = nlohmann::json::parse(said.text);
    const auto kernels_of = [&](const char* method, const char* edition) {
        return choices["methods"][method]["editions"][edition].get<std::vector<std::string>>();
    };
    using Kernels = std::vector<std::string>;
    const auto runs = [&](const char* method, const char* edition, const char* kernel) {
        const auto kernels = kernels_of(method, edition);
        return std::find(kernels.begin(), kernels.end(), kernel) != kernels.end();
    };
    for (const char* kernel : {"float", "double", "bits", "depth", "filtered", "grid", "exact"}) {
        CAPTURE(std::string(kernel));
        const std::string name = kernel;
        CHECK(runs("zbuffer", "corrected", kernel));
        CHECK(runs("warnock", "printed", kernel) == (name != "depth" && name != "filtered" && name != "grid"));
        CHECK(runs("floating-horizon", "corrected", kernel) == (name != "depth" && name != "grid"));
    }
    CHECK(kernels_of("warnock-full", "line-for-edge") == Kernels{"double", "exact"});
    CHECK(choices["editions"]["one-list"]["title"]["ru"] == "один список на все части");
    CHECK(choices["methods"]["warnock-angles"]["title"]["en"] == "sum of angles");
    CHECK_FALSE(choices["methods"]["weiler-atherton"]["editions"].contains("printed"));
    CHECK(choices["kernels"]["bits"]["parameter"] ==
          nlohmann::json{{"letter", "P"}, {"least", 4}, {"most", 24}, {"offered", {8, 12}}});
    CHECK(choices["kernels"]["exact"]["says"]["en"] == "Rational numbers of any length: nothing is rounded.");
    CHECK(choices["kernels"]["grid"]["snaps"] == true);
    CHECK(choices["kernels"]["exact"]["snaps"] == false);
    CHECK(choices["kernels"]["grid"]["alwaysRight"] == true);
    CHECK(choices["kernels"]["double"]["alwaysRight"] == false);
    CHECK(choices["editions"]["one-list"]["isMistake"] == true);
    CHECK(choices["deviations"]["one-list"]["defect"] == "x-w9");
    CHECK(choices["deviations"]["printed:x-w5"]["lines"] == nlohmann::json{"W3", "W13"});
    CHECK(choices["deviations"]["one-list"]["reads"][0]["en"] ==
          "else: push each quarter of U that overlaps the area, with APL itself");
    CHECK_FALSE(choices["deviations"]["printed:x-w5"].contains("reads"));
    CHECK(choices["methods"]["warnock-bodies"]["procedure"] == "Warnock");
    CHECK(choices["methods"]["warnock-bodies"]["reference"] == "warnock-bodies");
    CHECK(choices["methods"]["warnock-full"]["procedure"] == "ThreeListsWarnock");
    CHECK(choices["methods"]["warnock-full"]["reference"] == "zbuffer");
    CHECK(choices["methods"]["warnock-vertex"]["cutsAnywhere"] == true);
    CHECK(choices["methods"]["floating-horizon"]["cutsAnywhere"] == false);
    CHECK(choices["deviations"]["printed:x-h4"]["methods"] == nlohmann::json{"floating-horizon"});
}

TEST_CASE("stability: merged shards and a continued run give the bytes of a single run") {
    const Workplace work;
    const std::string campaign = "stability --family slivers --kernel double --method zbuffer --count 2 ";
    const auto whole = program(campaign + "-o " + work.file("whole.jsonl"));
    CHECK(whole.status == 0);
    CHECK(whole.text.find("wrong pixels in per cent") != std::string::npos);
    const std::string expected = work.read("whole.jsonl");

    CHECK(program(campaign + "--shard 1/2 -o " + work.file("1.jsonl")).status == 0);
    const auto half = program("stability --merge " + work.file("1.jsonl"));
    CHECK(half.status == 1);
    CHECK(half.text.find("blocks missing: 10 of 21") != std::string::npos);
    CHECK(program(campaign + "--shard 2/2 -o " + work.file("2.jsonl")).status == 0);
    const auto merged = program("stability --merge " + work.file("2.jsonl") + " " + work.file("1.jsonl") + " -o " +
                                work.file("merged.jsonl"));
    CHECK(merged.status == 0);
    CHECK(merged.text == whole.text);
    CHECK(work.read("merged.jsonl") == expected);

    const std::string cut = work.write("cut.jsonl", expected.substr(0, expected.size() / 2));
    CHECK(program(campaign + "-o " + cut).text == whole.text);
    CHECK(work.read("cut.jsonl") == expected);

    const auto other = program(campaign + "--seed 2 -o " + cut);
    CHECK(other.status == 2);
    CHECK(other.text.find("belongs to another campaign") != std::string::npos);
    CHECK(other.text.find('\n') == other.text.size() - 1);
    CHECK(work.read("cut.jsonl") == expected);
}

TEST_CASE("stability: a campaign that is killed and continued gives the same bytes") {
    const Workplace work;
    const std::string campaign = "stability --family slivers --kernel double --method zbuffer --count 40 ";
    const auto whole = program(campaign + "-o " + work.file("whole.jsonl"));
    REQUIRE(whole.status == 0);
    // It is killed at some point after it has written a few blocks.
    const std::string file = work.file("killed.jsonl");
    const auto killed = program("-c \"'" VIDNO_FILE "' " + campaign + "-o " + file + " & while [ ! -f " + file +
                                    " ] || [ \\$(wc -l < " + file +
                                    ") -lt 4 ]; do :; done; kill -9 \\$!; wait \\$!; echo ended by \\$?\"",
                                "/bin/sh");
    CHECK(killed.text.find("ended by 137") != std::string::npos);
    CHECK(work.read("killed.jsonl").size() < work.read("whole.jsonl").size());
    CHECK(program(campaign + "-o " + file).text == whole.text);
    CHECK(work.read("killed.jsonl") == work.read("whole.jsonl"));
}

TEST_CASE("stability: several blocks at a time give the same bytes") {
    const Workplace work;
    const std::string campaign = "stability --family edges horizon-ties --kernel float exact --method all --count 3 ";
    for (const std::string jobs : {"1", "2", "7"})
        REQUIRE(program(campaign + "--jobs " + jobs + " -o " + work.file(jobs)).status == 0);
    CHECK(work.read("2") == work.read("1"));
    CHECK(work.read("7") == work.read("1"));
}

TEST_CASE("stability: a failing trial of a merged file fails again alone, and its scene is painted wrong") {
    const Workplace work;
    const std::string results = work.file("results.jsonl"), scene = work.file("scene.json");
    REQUIRE(
        program("stability --seed 3 --family edges --kernel float --method zbuffer --count 20 -o " + results).status ==
        0);
    const std::string reported = program("stability --merge " + results).text;
    const std::size_t at = reported.find("edges:moved-");
    REQUIRE(at != std::string::npos);
    const std::string trial = reported.substr(at, reported.find('\n', at) - at);
    const auto again = program("stability --merge " + results + " --trial " + trial + " -o " + scene);
    CHECK(again.status == 0);
    CHECK(again.text.starts_with("float     zbuffer          wrong pixels "));
    CHECK_FALSE(again.text.starts_with("float     zbuffer          wrong pixels 0 "));
    for (const std::string kernel : {"float", "exact"})
        REQUIRE(
            program("render " + scene + " --method zbuffer --kernel " + kernel + " -o " + work.file(kernel + ".ppm"))
                .status == 0);
    CHECK(work.read("float.ppm") != work.read("exact.ppm"));
    CHECK(program("stability --trial edges:moved:1").text == "vidno: there is no experiment moved\n");
    CHECK(program("stability --trial edges:moved-1").text.find("not FAMILY:EXPERIMENT:N") != std::string::npos);
    CHECK(program("stability --trial horizon-ties:swept-by-ulps:1").text.find("are only moved") != std::string::npos);
}

TEST_CASE("stability: the shard of a task of Slurm") {
    const Workplace work;
    const std::string campaign = " stability --family slivers --kernel double --method zbuffer --count 1 -o ";
    const auto in_task = [&](const std::string& variables, const std::string& arguments) {
        return program(variables + " '" VIDNO_FILE "'" + arguments, "/usr/bin/env");
    };
    const auto array = [](const char* id, const char* least, const char* most, const char* count) {
        return std::string("SLURM_ARRAY_TASK_ID=") + id + " SLURM_ARRAY_TASK_MIN=" + least +
               " SLURM_ARRAY_TASK_MAX=" + most + " SLURM_ARRAY_TASK_COUNT=" + count;
    };
    REQUIRE(in_task(array("2", "1", "3", "3"), campaign + work.file("auto") + " --shard auto").status == 0);
    REQUIRE(program(campaign + work.file("said") + " --shard 2/3").status == 0);
    CHECK(work.read("auto") == work.read("said"));
    for (const std::string& part : {array("2", "2", "3", "2"), array("0", "0", "2", "3"), array("3", "1", "3", "2")}) {
        CHECK(in_task(part, campaign + work.file("part") + " --shard auto").status == 2);
        CHECK_FALSE(work.has("part"));
    }
    CHECK(program(campaign + work.file("part") + " --shard auto").text.find("not in an array") != std::string::npos);
}

TEST_CASE(
    "stability: the script for Slurm submits an array and the job that merges, and a killed task is queued again") {
    const Workplace work;
    // In place of Slurm: `sbatch` runs the tasks of an array at once, kills the program in task 2 the first time, and
    // then runs the other job; `scontrol` runs the task again.
    const std::string tools = work.file("tools");
    const auto tool = [&](const std::string& name, const std::string& text) {
        std::filesystem::permissions(work.write("tools/" + name, "#!/bin/bash\n" + text),
                                     std::filesystem::perms::owner_all);
    };
    tool("sbatch", R"sh(set -e
if [[ $1 == --parsable ]]; then
    export SLURM_ARRAY_JOB_ID=7
    for task in 1 2 3; do SLURM_ARRAY_TASK_ID=$task bash "${@: -1}" || true; done >&2
    echo '7;cluster'
else
    echo "$*" | grep -o 'afterany:[^ ]*'
    bash -c "${@: -1}"
fi
)sh");
    tool("scontrol",
         "echo \"$*\"\nSLURM_RESTART_COUNT=1 SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=${2#*_} bash campaign.sh\n");
    tool("vidno", "[[ \"$*\" == *2/3* && ! -e killed ]] && touch killed && kill -9 $$\nexec '" VIDNO_FILE "' \"$@\"\n");
    const std::string campaign = "stability --family edges --kernel float --method zbuffer --count 5 ";
    const auto in_folder = [&](const std::string& command) {
        return program("-c \"cd '" + work.directory.string() + "' && PATH='" + tools + "':\\$PATH && " + command + "\"",
                       "/bin/sh");
    };
    REQUIRE(in_folder("'" VIDNO_FILE "' " + campaign + "--script slurm --tasks 3 -o all.jsonl > campaign.sh").status ==
            0);
    const auto ran = in_folder("bash campaign.sh");
    CHECK(ran.status == 0);
    CHECK(ran.text.find("requeue 7_2\n") != std::string::npos);
    CHECK(ran.text.find("afterany:7\n") != std::string::npos);
    REQUIRE(program(campaign + "-o " + work.file("whole.jsonl")).status == 0);
    CHECK(work.read("all.jsonl") == work.read("whole.jsonl"));
}

TEST_CASE("import, then both methods paint the same picture of the mesh") {
    const Workplace work;
    const std::string scene = work.file("teapot.json");
    const auto imported = program("import " VIDNO_ROOT "/lessons/meshes/teapot.obj --width 64 --height 64 -o " + scene);
    CHECK(imported.status == 0);
    CHECK(imported.text.find("992 faces read") != std::string::npos);
    REQUIRE(program("render " + scene + " --method warnock --kernel exact -o " + work.file("a.ppm")).status == 0);
    REQUIRE(program("render " + scene + " --method zbuffer --kernel exact -o " + work.file("b.ppm")).status == 0);
    CHECK(work.read("a.ppm") == work.read("b.ppm"));
}

TEST_CASE("A run that a signal stops leaves no partial file") {
    // The system stops it with SIGXFSZ, number 25, when it writes beyond 512 bytes.
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene);
    const auto stopped = program("-c \"ulimit -f 1; '" VIDNO_FILE "' trace " + scene + " --detail signs -o " +
                                     work.file("run.jsonl") + "; echo ended by \\$?\"",
                                 "/bin/sh");
    CHECK(stopped.text.find("ended by 153") != std::string::npos);
    CHECK(work.files() == 1);
}

TEST_CASE("A pipe that is the output gets the bytes, and no file replaces it") {
    const Workplace work;
    const std::string scene = work.write("scene.json", square_scene), pipe = work.file("pipe.ppm");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const auto read = program(
        "-c \"'" VIDNO_FILE "' render " + scene + " -o " + pipe + " & timeout 20 cat " + pipe + "\"", "/bin/sh");
    CHECK(read.text == square_picture);
    CHECK(std::filesystem::is_fifo(pipe));
}

TEST_CASE("Lines that leave the range of doubles are drawn with finite numbers") {
    // The curve falls from 1.7e308 to -1.7e308 over 7 columns: it crosses the window at x = 3.5, in the middle.
    const Workplace work;
    const std::string surface =
        work.write("steep.json", R"({"format":"vidno-surface/1","window":{"x":0,"y":0,"width":8,"height":8},)"
                                 R"("curves":[[[0,1.7e308],[7,-1.7e308]]]})");
    const std::regex words(R"(>[^<\n]*</text>|\{[^{}\n]*\}\};)");  // a caption may say 1.70e+308
    const auto check_finite = [&](const std::string& call, const std::string& name) {
        CAPTURE(call);
        CHECK_MESSAGE(program(call + " -o " + work.file(name)).status == 1, "the curve leaves the window");
        const std::string drawing = std::regex_replace(work.read(name), words, "");
        CHECK_FALSE(drawing.empty());
        CHECK(drawing.find("inf") == std::string::npos);
        CHECK(drawing.find("nan") == std::string::npos);
        CHECK(drawing.find("e+") == std::string::npos);
    };
    const std::string run = work.file("steep.jsonl");
    CHECK_MESSAGE(program("trace " + surface + " -o " + run).status == 1, "its ends leave the range of doubles");
    for (const std::string ending : {".svg", ".tex"}) {
        check_finite("render " + surface, "render" + ending);
        check_finite("figure " + run + " --show picture,windows", "last" + ending);
        check_finite("figure " + run + " --steps 4,8,12 --show picture,windows", "strip" + ending);
    }
}
