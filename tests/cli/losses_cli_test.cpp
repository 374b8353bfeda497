// Nothing is lost in silence: each command says what its output lacks and where, exits with 1, and writes the output
// nevertheless.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "support/workplace.h"

namespace {

/// Three polygons that pierce each other. In double an outline of r does not close: exactly 19.073 square pixels of r
/// are visible.
const std::string piercing = R"({"window":{"x":0,"y":0,"width":16,"height":16},"polygons":[)"
                             R"({"id":"p","vertices":[[1,1,-0.7],[15,2,0.8],[13,14,0.6]]},)"
                             R"({"id":"q","vertices":[[1,14,0.55],[15,13,-0.45],[8,1,0.1]]},)"
                             R"({"id":"r","vertices":[[0,7,0.05],[16,6,0.05],[16,9,0.1],[0,10,0.1]]}]})";

/// The products of its coordinates exceed 2^128, the range of float, and are far from 2^1024, that of double.
const std::string wide = R"({"window":{"x":0,"y":0,"width":4,"height":4},"polygons":[)"
                         R"({"id":"wide","vertices":[[-1e25,-1e25,0.5],[1e25,-1e25,0.5],[0,1e25,0.5]]}]})";

/// The first curve rises to 20 in an area of 8 rows; the second stays within.
const std::string high = R"({"format":"vidno-surface/1","window":{"x":0,"y":0,"width":8,"height":8},)"
                         R"("curves":[[[0,1],[7,20]],[[0,1],[7,2]]]})";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("A run with a fault: each command names step, line and polygon, exits with 1 and writes its output") {
    const Workplace work;
    const std::string scene = work.write("scene.json", piercing);
    const std::string run = work.file("run.jsonl.gz");
    const std::string way = " --method weiler-atherton --kernel double -o ";

    const auto check_said = [&](const std::string& call, const std::string& output) {
        CAPTURE(call);
        const Outcome outcome = program(call + work.file(output));
        CAPTURE(outcome.text);
        CHECK(outcome.status == 1);
        CHECK(has(outcome.text, "an outline does not close"));
        CHECK(has(outcome.text, "step "));
        CHECK(has(outcome.text, "RC"));
        CHECK(has(outcome.text, "polygon \"r\""));
        CHECK(work.has(output));
    };
    for (const std::string output : {"a.png", "a.ppm", "a.json", "a.svg", "a.tex"}) {
        check_said("render " + scene + way, output);
    }
    check_said("trace " + scene + way, "run.jsonl.gz");
    check_said("trace " + scene + " --check" + way, "checked.jsonl");
    check_said("replay " + run + " -o ", "replay.png");
    check_said("replay " + run + " -o ", "state.json");
    check_said("figure " + run + " -o ", "figure.svg");
    check_said("figure " + run + " -o ", "figure.tex");
}

TEST_CASE("grade lists the faults that a trace reports, with step and line") {
    const Workplace work;
    const std::string scene = work.write("scene.json", piercing);
    const std::string run = work.file("run.jsonl");
    program("trace " + scene + " --method weiler-atherton --kernel double -o " + run);
    const Outcome english = program("grade " + run);
    CAPTURE(english.text);
    CHECK(has(english.text, "Faults that the trace reports:\n"));
    CHECK(has(english.text, ": step "));
    CHECK(has(english.text, ", RC"));
    CHECK(has(english.text, "an outline does not close"));
    const Outcome russian = program("grade --language ru " + run);
    CHECK(has(russian.text, "Сбои, о которых сообщает запись:\n"));
    CHECK(has(russian.text, "контур не замыкается"));
    program("trace " + scene + " --method weiler-atherton --kernel exact -o " + run);
    CHECK_FALSE(has(program("grade " + run).text, "Faults"));
}

TEST_CASE("A lesson says what its scene lacks of the mesh") {
    const Workplace work;
    const std::string mesh = work.write("mesh.obj", "v 0 0 0\nv 4 0 0\nv 0 3 0\nl 1 2\nf 1 2 3\n");
    const Outcome made = program("lesson new " + mesh + " -o " + work.file("lesson"));
    CAPTURE(made.text);
    CHECK(made.status == 1);
    CHECK(has(made.text, mesh + ": line 4: left out: lines and points"));
    CHECK(work.has("lesson/scene.json"));
}

TEST_CASE("A step before the fault lacks nothing") {
    const Workplace work;
    const std::string scene = work.write("scene.json", piercing);
    const std::string run = work.file("run.jsonl");
    program("trace " + scene + " --method weiler-atherton -o " + run);
    CHECK(program("replay " + run + " --step 1 -o " + work.file("a.ppm")).status == 0);
    CHECK(program("figure " + run + " --step 1 -o " + work.file("a.svg")).status == 0);
}

TEST_CASE("A kernel that is always right loses nothing, and says nothing") {
    const Workplace work;
    for (const std::string& text : {piercing, wide}) {
        const std::string scene = work.write("scene.json", text);
        for (const std::string method : {"warnock", "zbuffer", "weiler-atherton"}) {
            for (const std::string kernel : {"filtered", "exact"}) {
                CAPTURE(method);
                CAPTURE(kernel);
                const Outcome outcome = program("render " + scene + " --method " + method + " --kernel " + kernel +
                                                " -o " + work.file("a.ppm"));
                CHECK(outcome.status == 0);
                CHECK(outcome.text.empty());
            }
        }
    }
}

TEST_CASE("A polygon whose plane leaves the range of the numbers is named by every method") {
    const Workplace work;
    const std::string scene = work.write("wide.json", wide);
    for (const std::string method :
         {"warnock", "zbuffer", "weiler-atherton", "warnock-simplest", "warnock-full", "warnock-angles"}) {
        CAPTURE(method);
        const Outcome outcome =
            program("render " + scene + " --method " + method + " --kernel float -o " + work.file("a.ppm"));
        CAPTURE(outcome.text);
        CHECK(program("render " + scene + " --method " + method + " --kernel double -o " + work.file("b.ppm")).status ==
              0);
        const bool is_right = work.read("a.ppm") == work.read("b.ppm");
        CHECK(outcome.status == (is_right ? 0 : 1));
        CHECK(has(outcome.text, "every pixel is right nevertheless") == is_right);
        CHECK(has(outcome.text, "polygon \"wide\": its plane leaves the range of the numbers"));
    }
}

TEST_CASE("A curve that leaves the area is named wherever it is drawn") {
    const Workplace work;
    const std::string surface = work.write("high.json", high);
    const std::string run = work.file("run.jsonl");
    REQUIRE_MESSAGE(program("trace " + surface + " -o " + run).status == 0, "a trace has the whole curve");
    for (const std::string& call : {"render " + surface, "replay " + run, "figure " + run}) {
        for (const std::string ending : {".svg", ".tex", ".pdf"}) {
            CAPTURE(call);
            const Outcome outcome = program(call + " -o " + work.file("lines" + ending));
            CAPTURE(outcome.text);
            CHECK(outcome.status == 1);
            CHECK(has(outcome.text, "curve 0: its part above or below the area is cut off"));
            CHECK_FALSE(has(outcome.text, "curve 1"));
            CHECK(work.has("lines" + ending));
        }
    }
}

TEST_CASE("A command names the pixels outside the area that the printed text writes, the first ones one by one") {
    // As printed, ShowLine also scans the row and the column just past the area, so a polygon over all 16 x 16 pixels
    // is written beyond them.
    const Workplace work;
    const std::string scene =
        work.write("scene.json", R"({"window":{"x":0,"y":0,"width":16,"height":16},"polygons":[)"
                                 R"({"id":"all","vertices":[[-2,-2,0],[18,-2,0],[18,18,0],[-2,18,0]]}]})");
    const Outcome outcome = program("render " + scene + " --method zbuffer --edition printed -o " + work.file("a.ppm"));
    CAPTURE(outcome.text);
    CHECK(outcome.status == 0);
    CHECK(has(outcome.text, "every pixel is right nevertheless"));
    CHECK(has(outcome.text, "L6, polygon \"all\", pixel (16, "));
    CHECK(has(outcome.text, "outside the area, so the write is skipped"));
    CHECK(has(outcome.text, "more losses of this run"));
    CHECK(work.has("a.ppm"));
}

TEST_CASE("Every command says that a trace is cut, wherever it is cut, and at whichever step it is drawn") {
    const Workplace work;
    const std::string scene = work.write("scene.json", R"({"window":{"x":0,"y":0,"width":4,"height":4},"polygons":[)"
                                                       R"({"vertices":[[0,0,0],[3,0,0],[3,3,0],[0,3,0]]}]})");
    REQUIRE(program("trace " + scene + " -o " + work.file("whole.jsonl")).status == 0);
    REQUIRE(program("trace " + scene + " -o " + work.file("whole.jsonl.gz")).status == 0);
    const std::string whole = work.read("whole.jsonl"), packed = work.read("whole.jsonl.gz");
    const std::string last = whole.substr(0, whole.rfind("\n{") + 1);
    const std::vector<std::string> cut{
        work.write("in-a-line.jsonl", whole.substr(0, whole.size() - 150)),
        work.write("between-lines.jsonl", last),
        work.write("in-the-last-line.jsonl", whole.substr(0, whole.size() - 20)),
    };
    for (const auto& trace : cut) {
        const std::vector<std::string> calls{
            "replay " + trace + " -o " + work.file("a.ppm"),
            "replay " + trace + " --step 1 -o " + work.file("a.ppm"),
            "replay " + trace + " -o " + work.file("a.jsonl"),
            "figure " + trace + " -o " + work.file("a.svg"),
            "figure " + trace + " --step 1 -o " + work.file("a.svg"),
            "figure " + trace + " --steps 1..3 -o " + work.file("a.tex"),
            "diff " + trace + " " + trace,
            "diff " + work.file("whole.jsonl") + " " + trace,
            "diff " + trace + " " + work.file("whole.jsonl.gz"),
            "check " + trace,
        };
        for (const auto& call : calls) {
            CAPTURE(call);
            const Outcome outcome = program(call);
            CAPTURE(outcome.text);
            CHECK(outcome.status == 1);
            CHECK(has(outcome.text, "cut short"));
        }
    }
    for (const std::string call : {"replay ", "figure "}) {
        CHECK(program(call + work.file("whole.jsonl") + " --step 1 -o " +
                      work.file("b.svg").replace(work.file("b.svg").size() - 3, 3, call == "replay " ? "ppm" : "svg"))
                  .status == 0);
    }
    CHECK(program("diff " + work.file("whole.jsonl") + " " + work.file("whole.jsonl.gz")).status == 0);
}

TEST_CASE("Compressed data with a wrong checksum are called damaged, however few they are") {
    const Workplace work;
    const std::string scene = work.write("scene.json", R"({"window":{"x":0,"y":0,"width":4,"height":4},"polygons":[)"
                                                       R"({"vertices":[[0,0,0],[3,0,0],[3,3,0],[0,3,0]]}]})");
    REQUIRE(program("trace " + scene + " -o " + work.file("run.jsonl.gz")).status == 0);
    std::string damaged = work.read("run.jsonl.gz");
    damaged[damaged.size() - 8] = char(damaged[damaged.size() - 8] ^ 1);  // the checksum comes before the length
    const std::string run = work.write("damaged.jsonl.gz", damaged);
    for (const std::string& call :
         {"replay " + run + " -o " + work.file("a.ppm"), "figure " + run + " -o " + work.file("a.svg"),
          "diff " + run + " " + run, "check " + run}) {
        CAPTURE(call);
        const Outcome outcome = program(call);
        CAPTURE(outcome.text);
        CHECK(outcome.status != 0);
        CHECK(has(outcome.text, "damaged"));
        CHECK_FALSE(has(outcome.text, "empty, not a trace"));
    }
}

TEST_CASE("A mesh where a scene is expected: the message names vidno import") {
    const Workplace work;
    const std::string mesh = work.write("cube.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const std::string& call :
         {"render " + mesh + " -o " + work.file("a.ppm"), "trace " + mesh + " -o " + work.file("a.jsonl"),
          "check " + mesh, "need " + mesh, "choose " + mesh, "figure " + mesh + " -o " + work.file("a.svg"),
          "chart " + mesh + " -o " + work.file("a.json"), "margin " + mesh + " --step 1 --vertex A.0"}) {
        CAPTURE(call);
        const Outcome outcome = program(call);
        CHECK(outcome.status == 2);
        CHECK(has(outcome.text, "vidno import " + mesh));
    }
}
