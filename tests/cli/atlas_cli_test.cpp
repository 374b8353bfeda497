// The atlas of failures through the command line: each entry is run as it fails. Its step and what is seen there must
// agree with the table, which lessons/failures/table.mjs derives from traces alone.

#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/workplace.h"

namespace {

using nlohmann::json;

const std::string atlas = VIDNO_ROOT "/lessons/failures/";

/// What the table states about an entry.
struct Stated {
    std::string step, there;
};

/// By the names of the entries' files.
std::map<std::string, Stated> table() {
    std::map<std::string, Stated> rows;
    std::istringstream lines(text_of(atlas + "README.md"));
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| [", 0) != 0) continue;
        std::vector<std::string> cells;
        for (std::size_t at = 2; at < line.size();) {
            const auto end = line.find(" | ", at);
            cells.push_back(line.substr(at, end - at));
            at = end == line.npos ? end : end + 3;
        }
        REQUIRE(cells.size() == 6);
        const auto name = cells[0].substr(cells[0].find("](") + 2);
        rows[name.substr(0, name.size() - 1)] = {cells[3], cells[4]};
    }
    return rows;
}

struct Entry {
    std::string file;
    json reported;
    Stated stated;
};

std::vector<Entry> entries_with_scenes() {
    std::vector<Entry> entries;
    for (const auto& [name, stated] : table()) {
        Entry entry{atlas + name, json::parse(text_of(atlas + name)), stated};
        if (entry.reported.contains("scene")) entries.push_back(entry);
    }
    return entries;
}

std::string options_of(const json& run) {
    std::string options;
    for (const auto& [name, value] : run.items()) {
        if (name != "scene") options += " --" + name + " " + value.get<std::string>();
    }
    return options;
}

/// The colour of a pixel of a PPM.
std::string pixel_of(const std::string& picture, const json& window, int x, int y) {
    const auto width = window.at("width").get<int>(), height = window.at("height").get<int>();
    const auto begin = picture.size() - std::size_t(3 * width * height);
    const int place = (y - window.at("y").get<int>()) * width + x - window.at("x").get<int>();
    return picture.substr(begin + std::size_t(3 * place), 3);
}

}  // namespace

TEST_CASE("Atlas: trace runs each entry as it fails, and prints title, step, what is seen there, and remedy") {
    const Workplace work;
    const auto entries = entries_with_scenes();
    CHECK(entries.size() >= 52);
    for (const auto& entry : entries) {
        const auto& file = entry.file;
        const auto& reported = entry.reported;
        const auto& stated = entry.stated;
        CAPTURE(file);
        const auto traced = program("trace " + file + " --max-events 20000 -o " + work.file("run.jsonl"));
        CHECK(traced.status <= 1);
        CHECK(traced.text.find(file + ": " + reported["title"]["en"].get<std::string>() + '\n') != std::string::npos);
        CHECK(traced.text.find(file + ": remedy: " + reported["remedy"]["en"].get<std::string>() + '\n') !=
              std::string::npos);
        const std::string step = stated.step.empty() ? "" : "step " + stated.step + ": ";
        CHECK_MESSAGE(traced.text.find(file + ": " + step + stated.there + '\n') != std::string::npos, traced.text);
        const std::string trace = work.read("run.jsonl");
        const json header = json::parse(trace.substr(0, trace.find('\n')));
        for (const std::string part : {"method", "kernel", "edition"}) CHECK(header[part] == reported["fails"][part]);
    }
}

TEST_CASE("Atlas: render paints the pixel of each entry otherwise than the remedy does") {
    const Workplace work;
    int pixels = 0;
    for (const auto& entry : entries_with_scenes()) {
        const auto& file = entry.file;
        const auto& reported = entry.reported;
        if (!reported["shows"].contains("pixel")) continue;
        CAPTURE(file);
        REQUIRE_MESSAGE(program("render " + file + " -o " + work.file("fails.ppm")).status <= 1,
                        "it may lose something");
        REQUIRE(program("render " + file + options_of(reported["holds"]) + " -o " + work.file("holds.ppm")).status ==
                0);
        const auto pixel = [&](const std::string& picture) {
            const json& at = reported["shows"]["pixel"];
            return pixel_of(work.read(picture), reported["scene"]["window"], at[0], at[1]);
        };
        CHECK(pixel("fails.ppm") != pixel("holds.ppm"));
        ++pixels;
    }
    CHECK(pixels >= 35);
}

TEST_CASE("Atlas: commands that do not run an entry take its scene") {
    const Workplace work;
    const std::string entry = atlas + "clip-pixel.json";
    const std::string title = entry + ": A rounded intersection causes a wrong pixel\n";
    for (const std::string& call : {
             "check " + entry,
             "need " + entry,
             "choose " + entry,
             "render " + entry + " -o " + work.file("a.png"),
             "shrink " + entry + " -o " + work.file("a.json"),
             "chart " + entry + " -o " + work.file("a.csv"),
             "homework " + entry + " --count 1 -o " + work.file("homework"),
             "worksheet " + entry + " -o " + work.file("a.pdf"),
             "figure " + entry + " -o " + work.file("a.svg"),
         }) {
        CAPTURE(call);
        const auto done = program(call);
        CHECK_MESSAGE(done.status <= 1, done.text);
        CHECK(done.text.find(title) != std::string::npos);
    }
    CHECK_MESSAGE(work.read("a.svg").find("step 74") != std::string::npos,
                  "the figure is of the step where it is seen");
}

TEST_CASE("Atlas: options on the command line take precedence") {
    const Workplace work;
    const std::string entry = atlas + "clip-pixel.json";
    const auto fails = program("check " + entry), holds = program("check " + entry + " --kernel filtered");
    CHECK(fails.status == 1);
    CHECK(fails.text.find("step 74: the columns: computed 15, exact 14 to 15") != std::string::npos);
    CHECK(holds.status == 0);
    CHECK_MESSAGE(holds.text.find("step 74: the columns") == std::string::npos,
                  "that is the step of the run that fails");
}

TEST_CASE("Atlas: map shows the orientation at which an entry goes wrong, and refuses another decision") {
    const auto mapped = program("map " + atlas + "orientation-inverted.json");
    CHECK(mapped.status == 1);
    CHECK(mapped.text.find("orientation under double\n") != std::string::npos);
    const auto refused = program("map " + atlas + "clip-pixel.json");
    CHECK(refused.status == 2);
    CHECK(refused.text.find("this is another failure: the columns: computed 15, exact 14 to 15") != std::string::npos);
}

TEST_CASE("Atlas: an entry that no scene can show is refused with the name of its test") {
    const auto refused = program("check " + atlas + "contraction-to-fma.json");
    CHECK(refused.status == 2);
    CHECK(refused.text.find("no scene shows it: see the test \"Failures: a fused multiply-add") != std::string::npos);
}

TEST_CASE("Atlas: all errors in a new entry are reported at once, with their places") {
    const Workplace work;
    const std::string file =
        work.write("own.json",
                   "{\"title\": {\"en\": \"A\"},\n"
                   " \"why\": {\"en\": \"B\", \"ru\": \"B\"}, \"remedy\": {\"en\": \"C\", \"ru\": \"C\"},\n"
                   " \"scene\": {\"polygons\": [{\"vertices\": [[0, 0, 0], [4, 0, 0], [0, 4, 2]]}]},\n"
                   " \"fails\": {\"method\": \"warnock\", \"kernel\": \"half\", \"edition\": \"printed\"},\n"
                   " \"shows\": {\"pixel\": [0]}}\n");
    const std::string reported = program("trace " + file + " -o " + work.file("a.jsonl")).text;
    std::string expected = "vidno: ";
    for (const std::string fault :
         {"line 1, column 1: \"holds\" is missing", "line 1, column 11: /title: \"ru\" is missing",
          "line 3, column 68: /scene/polygons/0/vertices/2/2: z outside -1 to 1",
          "line 4, column 43: /fails/kernel: not one of float, double, bits:P (4 <= P <= 24), depth:B (2 <= B <= 32), "
          "filtered, grid:K (1 <= K <= 20), exact",
          "line 5, column 21: /shows/pixel: not two whole numbers"}) {
        expected += file + ": " + fault + '\n';
    }
    CHECK(reported == expected);
}
