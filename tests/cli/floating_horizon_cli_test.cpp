// The program with surfaces, as its users call it.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/workplace.h"

using nlohmann::json;

namespace {

/// Two lines that cross at (2.5, 8): the second is drawn below the first, and above it.
const std::string crossing =
    R"({"format":"vidno-surface/1","name":"crossing","window":{"x":0,"y":0,"width":9,"height":16},)"
    R"("curves":[[[0,8],[4,8]],[[0,13],[4,5]]]})";
const std::string square = R"({"format":"vidno-scene/1","window":{"x":0,"y":0,"width":2,"height":1},"polygons":[]})";

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST_CASE("surfaces: render draws lines, and replay draws the same from the events") {
    const Workplace work;
    const std::string surface = work.write("s.json", crossing);
    for (const std::string extension : {".svg", ".pdf", ".png"}) {
        CAPTURE(extension);
        CHECK(program("render " + surface + " -o " + work.file("a" + extension)).status == 0);
        for (const std::string detail : {"windows", "polygons", "signs"}) {
            const std::string trace = work.file("run.jsonl.gz");
            CHECK(program("trace " + surface + " --detail " + detail + " -o " + trace).status == 0);
            CHECK(program("replay " + trace + " -o " + work.file("b" + extension)).status == 0);
            CHECK(work.read("a" + extension) == work.read("b" + extension));
        }
    }
    // 80 mm for 9 columns: (0, 8), (4, 8); (0, 13), (2.5, 8), (4, 5).
    CHECK(has(work.read("a.svg"), "M0 71.111 35.556 71.111M0 115.556 22.222 71.111 35.556 44.444"));
}

TEST_CASE("surfaces: replay --step, and the state as JSON") {
    const Workplace work;
    const std::string surface = work.write("s.json", crossing);
    const std::string trace = work.file("run.jsonl");
    REQUIRE(program("trace " + surface + " --detail windows -o " + trace).status == 0);
    // curve 0 and its line in four columns; curve 1 to where it crosses, and on.
    CHECK(program("replay " + trace + " --step 2 -o " + work.file("a.json")).status == 0);
    CHECK(has(work.read("a.json"), R"("lines":[[0,[0,8],[1,8]]],"curve":0,"segment":[0,4])"));
    CHECK(program("replay " + trace + " -o " + work.file("b.json")).status == 0);
    CHECK(has(work.read("b.json"), R"("lines":[[0,[0,8],[4,8]],[1,[0,13],[2.5,8]],[1,[2.5,8],[4,5]]],"curve":1)"));
    CHECK(program("replay " + trace + " -o " + work.file("all.jsonl")).status == 0);
}

TEST_CASE("surfaces: a trace ends at a condition, and a search finds curves that meet one") {
    const Workplace work;
    const std::string surface = work.write("s.json", crossing);
    REQUIRE(program("trace " + surface + " -o " + work.file("whole.jsonl")).status == 0);
    const auto cut = program("trace " + surface + " --until 'FH8 > 0' -o " + work.file("cut.jsonl"));
    CHECK(cut.status == 1);
    CHECK(has(cut.text, "(--until FH8 > 0)"));
    const std::string text = work.read("cut.jsonl");
    const std::string steps = text.substr(0, text.rfind("{\"end\""));
    CHECK(work.read("whole.jsonl").starts_with(steps));
    CHECK(has(steps.substr(steps.rfind('\n', steps.size() - 2)), R"("at":"FH8")"));
    CHECK(program("trace " + surface + " --until 'windows > 0' -o " + work.file("no.jsonl")).text ==
          "vidno: --method floating-horizon: windows is only for polygons\n");

    REQUIRE(program("find 'FH8 > 0 && curves == 2' -o " + work.file("found.json")).status == 0);
    CHECK(json::parse(work.read("found.json")).at("name") == "FH8 > 0 && curves == 2");
    CHECK(program("trace " + work.file("found.json") + " --until 'FH8 > 0' -o " + work.file("b.jsonl")).status == 1);
}

TEST_CASE("surfaces: a changed, truncated or partial trace is detected") {
    const Workplace work;
    const std::string surface = work.write("s.json", crossing);
    const std::string trace = work.file("run.jsonl");
    REQUIRE(program("trace " + surface + " -o " + trace).status == 0);
    std::string text = work.read("run.jsonl");
    const std::string cut = work.write("cut.jsonl", text.substr(0, text.rfind("{\"end\"")));
    CHECK(program("replay " + cut + " -o " + work.file("a.svg")).status == 1);
    const std::string end = R"("to":[2.5,8])";
    const std::string changed =
        work.write("changed.jsonl", text.replace(text.find(end), end.size(), R"("to":[2.5,9])"));
    CHECK(program("replay " + changed + " -o " + work.file("a.svg")).status == 1);
    CHECK(program("trace " + surface + " --max-events 5 -o " + trace).status == 1);
    CHECK(program("replay " + trace + " -o " + work.file("a.svg")).status == 1);
}

TEST_CASE("surfaces: diff prints where editions diverge, check prints what is wrong") {
    const Workplace work;
    const std::string surface = work.write("s.json", crossing);
    const std::string right = work.file("right.jsonl"), printed = work.file("printed.jsonl");
    REQUIRE(program("trace " + surface + " -o " + right).status == 0);
    REQUIRE(program("trace " + surface + " --edition printed -o " + printed).status == 0);
    CHECK(program("diff " + right + " " + right).status == 0);
    const auto difference = program("diff " + right + " " + printed);
    CHECK(difference.status == 1);
    CHECK(has(difference.text, R"(the traces differ from step 1 on
- {"e":"horizons","at":"FH1"}
+ {"e":"horizons","at":"FH1","upper":16,"lower":0}
)"));
    const auto checked = program("check " + right);
    CHECK(checked.status == 0);
    CHECK(has(checked.text, "Visibility"));
    CHECK(has(checked.text, "wrong columns of curves: 0 of 10"));
    CHECK(program("check " + surface + " --kernel exact").status == 0);
    // As printed, a step that is below at both ends is not drawn (X-H1): the second of two level lines.
    const std::string below =
        work.write("below.json", R"({"format":"vidno-surface/1","window":{"x":0,"y":0,"width":9,"height":16},)"
                                 R"("curves":[[[0,4],[4,4]],[[0,12],[4,12]]]})");
    CHECK(program("check " + below).status == 0);
    const auto lost = program("check " + below + " --edition printed");
    CHECK(lost.status == 1);
    CHECK(has(lost.text, "wrong columns of curves: 5 of 10"));
}

TEST_CASE("surfaces: a function, checked, as a figure") {
    const Workplace work;
    const std::string surface = VIDNO_ROOT "/lessons/surfaces/waves-and-pit.json";
    const std::string trace = work.file("run.jsonl.gz");
    REQUIRE(program("trace " + surface + " --detail polygons --check -o " + trace).status == 0);
    const std::string figure =
        "figure " + trace + " --step 9000 --show picture,windows,listing -o " + work.file("a.svg");
    CHECK(program(figure).status == 0);
    const std::string first = work.read("a.svg");
    CHECK(program(figure).status == 0);
    CHECK(work.read("a.svg") == first);
    CHECK(has(first, "Waves and a pit · Floating horizon · step 9000"));
    CHECK(program("figure " + trace + " --steps 100,9000 -o " + work.file("a.tex")).status == 0);
}

TEST_CASE("surfaces: a half ball has gaps in every output, which are said once and are no loss") {
    const Workplace work;
    // At z = 1 and -1 three of five samples are in the half ball, at 0 all five, at 2 and -2 one.
    const std::string surface =
        work.write("ball.json", R"json({"function":"sqrt(4 - x^2 - z^2)","x":[-2,2],"z":[2,-2],"curves":5,"samples":5,
                   "view":{"origin":[0,12],"across":[8,0],"back":[1,-1],"up":1}})json");
    const std::string gaps = surface +
                             ": gaps: no finite height at 12 of 25 samples, first at curve 0, column 0; "
                             "2 samples between gaps are not drawn\n";
    const auto check_said = [&](const std::string& call) {
        CAPTURE(call);
        const auto [status, text] = program(call);
        CAPTURE(text);
        CHECK(status == 0);
        CHECK(text.find(gaps) != text.npos);
        CHECK(text.find("gaps:") == text.rfind("gaps:"));
    };
    const std::string trace = work.file("run.jsonl");
    check_said("trace " + surface + " -o " + trace);
    check_said("check " + surface);
    check_said("check " + surface + " --kernel exact");
    for (const std::string extension : {".svg", ".pdf", ".png", ".tex"}) {
        check_said("render " + surface + " -o " + work.file("a" + extension));
        CHECK(program("replay " + trace + " -o " + work.file("b" + extension)).status == 0);
        CHECK(work.read("a" + extension) == work.read("b" + extension));
        CHECK(program("figure " + trace + " --show picture,windows,listing -o " + work.file("c" + extension)).status ==
              0);
    }
    CHECK(has(work.read("run.jsonl"), R"("curves":[[[0,null],[2,null],[4,12],[6,null],[8,null]],[[1,null],[3,)"));
    CHECK(program("grade " + trace).status == 0);
    check_said("worksheet " + surface + " -o " + work.file("blank.pdf") + " --key " + work.file("key.pdf"));
    check_said("chart " + surface + " -o " + work.file("chart.json"));
}

TEST_CASE("surfaces: refusals and their reasons") {
    const Workplace work;
    const std::string surface = work.write("s.json", crossing);
    const std::string polygons = work.write("p.json", square);
    const std::string trace = work.file("run.jsonl");
    REQUIRE(program("trace " + surface + " -o " + trace).status == 0);
    const std::string output = " -o " + work.file("out.jsonl");
    const auto refusal = [](const std::string& call) {
        const auto [status, text] = program(call);
        CHECK(status == 2);
        return text;
    };
    CHECK(refusal("trace " + surface + " --method zbuffer" + output) ==
          "vidno: " + surface + ": a surface, which only --method floating-horizon draws\n");
    CHECK(refusal("trace " + polygons + " --method floating-horizon" + output) ==
          "vidno: --method floating-horizon: " + polygons + " is not a surface, vidno-surface/1\n");
    CHECK(refusal("trace " + surface + " --kernel grid:4" + output) == "vidno: --kernel grid:4: only for polygons\n");
    CHECK(refusal("trace " + surface + " --kernel filtered --edition printed" + output) ==
          "vidno: --edition printed: not under --kernel filtered, whose decisions are always right\n");
    CHECK(refusal("trace " + surface + " --edition one-list" + output) ==
          "vidno: --edition one-list: a mistake of --method warnock alone\n");
    CHECK(refusal("render " + surface + " -o " + work.file("a.ppm")).starts_with("vidno: " + work.file("a.ppm")));
    CHECK(refusal("check " + trace + " --method warnock") ==
          "vidno: --method warnock: " + trace + " is a trace of curves\n");
    CHECK(refusal("figure " + trace + " --show list -o " + work.file("a.svg"))
              .starts_with("vidno: a run of curves has no list"));
    CHECK(refusal("worksheet " + trace + " -o " + work.file("a.xml")) ==
          "vidno: " + trace + ":1: /method: floating-horizon, which this command does not take\n");
    CHECK_FALSE(work.has("out.jsonl"));
}

TEST_CASE("surfaces: a command for polygons says so in a sentence, and writes nothing") {
    const Workplace work;
    const std::string surface = work.write("s.json", crossing);
    const auto refused = [&](const std::string& call, const std::string& sentence) {
        CAPTURE(call);
        const auto [status, text] = program(call);
        CHECK(status == 2);
        CHECK(text == "vidno: " + sentence + "\n");
    };
    const std::string for_polygons = surface + ": a surface, but this command takes scenes of polygons, vidno-scene/1";
    refused("shrink " + surface + " -o " + work.file("out.json"), for_polygons);
    refused("need " + surface, for_polygons);
    refused("choose " + surface, for_polygons);
    refused("homework " + surface + " -o " + work.file("out"), for_polygons);
    refused("worksheet --method warnock " + surface + " -o " + work.file("out.pdf"),
            surface + ": a surface, which only --method floating-horizon draws");
    refused("map " + surface, surface + ": a surface, not a decision to map, vidno-question/1");
    refused("figure " + surface + " -o " + work.file("out.svg"),
            surface + ": a surface; vidno render draws surfaces, and vidno figure draws their traces");
    CHECK_MESSAGE(work.files() == 1, "the surface");
}

TEST_CASE("surfaces: a chart varies the sampling of a function, and the output's name selects the format") {
    const Workplace work;
    const std::string function = work.write(
        "f.json", R"({"format":"vidno-surface/1","name":"Wave","window":{"x":0,"y":0,"width":9,"height":16},)"
                  R"("function":"sin(x) + z","x":[0,6],"z":[1,0],"curves":2,"samples":3,)"
                  R"("view":{"origin":[0,8],"across":[8,0],"back":[0,-1],"up":2}})");
    REQUIRE(program("chart " + function + " -o " + work.file("a.json")).status == 0);
    CHECK(work.read("a.json").starts_with(R"({"format":"vidno-chart/1","rounds":5,"surfaces":[)"));
    REQUIRE(program("chart " + function + " " + function + " -o " + work.file("a.csv")).status == 0);
    CHECK(work.read("a.csv").starts_with("surface.name,"));
    REQUIRE(program("chart " + function + " --cost samples --error height -o " + work.file("a.svg")).status == 0);
    CHECK(has(work.read("a.svg"), "height missed, pixels"));
    REQUIRE(program("figure " + work.file("a.json") + " --language ru -o " + work.file("b.svg")).status == 0);
    CHECK(has(work.read("b.svg"), "неверные столбцы, %"));

    const std::string sampled = work.write("s.json", crossing);
    const std::string polygons = work.write("p.json", square);
    const auto refusal = [&](const std::string& arguments, const std::string& name) {
        const auto [status, text] = program("chart " + arguments + " -o " + work.file(name));
        CHECK(status == 2);
        CHECK_FALSE(work.has(name));
        return text;
    };
    CHECK(refusal(sampled, "c.json") ==
          "vidno: " + sampled + ": line 1, column 1: has no function that could be sampled in other ways\n");
    CHECK(refusal(function + " " + polygons, "c.json") ==
          "vidno: " + polygons + ": a chart shows scenes or surfaces, not both\n");
    CHECK(refusal(function + " --error area", "c.svg") ==
          "vidno: --error area: this chart has wrongColumns, height, wrongDecisions\n");
    CHECK(refusal(polygons + " --cost samples", "c.svg") ==
          "vidno: --cost samples: this chart has time, operations, bits\n");
}

TEST_CASE("surfaces: the page of a chart is the built one with the chart in it, its surface, and the page of traces") {
    const Workplace work;
    // The page that the program finds beside its own folder.
    const std::string chart_block = R"(<script type="application/json" id="vidno-chart">)";
    const std::string replay_block = R"(<script type="application/json" id="vidno-replay">)";
    work.write("share/vidno/chart.html",
               "<html>" + chart_block + "null</script>" + replay_block + "\"index.html\"</script></html>");
    const std::string traces = work.write("share/vidno/index.html", "");
    std::filesystem::create_directories(work.directory / "bin");
    std::filesystem::copy_file(VIDNO_FILE, work.directory / "bin/vidno");
    const std::string surface = work.write(
        "f.json", R"({"format":"vidno-surface/1","name":"</script>","window":{"x":0,"y":0,"width":9,"height":16},)"
                  R"("function":"sin(x) + z","x":[0,6],"z":[1,0],"curves":2,"samples":3,"tolerance":0.5,)"
                  R"("view":{"origin":[0,8],"across":[8,0],"back":[0,-1],"up":2}})");
    REQUIRE(program("chart " + surface + " -o " + work.file("a.html"), work.file("bin/vidno")).status == 0);

    const std::string page = work.read("a.html");
    const std::string begin = "<html>" + chart_block;
    const std::string end =
        "</script>" + replay_block + "\"file://" + std::filesystem::canonical(traces).string() + "\"</script></html>";
    REQUIRE(page.starts_with(begin));
    REQUIRE(page.ends_with(end));
    const std::string block = page.substr(begin.size(), page.size() - begin.size() - end.size());
    CHECK_MESSAGE(!has(block, "<"), "no name ends the block");
    const json chart = json::parse(block);
    CHECK(chart["format"] == "vidno-chart/1");
    CHECK(chart["surfaces"][0]["name"] == "</script>");
    CHECK_MESSAGE(chart["surfaces"][0]["surface"] == json::parse(work.read("f.json")), "the page links its runs");

    std::filesystem::remove(work.file("share/vidno/chart.html"));
    const auto unbuilt = program("chart " + surface + " -o " + work.file("b.html"), work.file("bin/vidno"));
    CHECK(unbuilt.status == 2);
    CHECK(has(unbuilt.text, "chart.html: not there; ./dev demo builds the page"));
    CHECK_FALSE(work.has("b.html"));
}

TEST_CASE("surfaces: methods names domain and rule") {
    const std::string text = program("methods").text;
    CHECK(has(text, "floating-horizon"));
    CHECK(has(text, "strictly between the horizons"));
}
