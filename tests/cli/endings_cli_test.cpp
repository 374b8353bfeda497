// How the program ends: an empty argument, a full device and a signal are noticed, and nothing unfinished remains.

#include <doctest/doctest.h>

#include <csignal>
#include <sstream>
#include <string>
#include <vector>

#include "support/workplace.h"

namespace {

const std::string scene_text = R"({"window":{"x":0,"y":0,"width":4,"height":4},"polygons":[)"
                               R"({"id":"A","vertices":[[0,0,0],[3,0,0],[3,3,0],[0,3,0]]}]})";

/// In a shell, which sees `$vidno`. The status of a program that a signal ended is 128 and its number.
Outcome shell(const std::string& command) {
    std::string quoted;
    for (const char c : "vidno='" VIDNO_FILE "'; " + command) {
        if (c == '$' || c == '"' || c == '\\' || c == '`') quoted += '\\';
        quoted += c;
    }
    return program("-c \"" + quoted + "\"", "/bin/sh");
}

}  // namespace

TEST_CASE("An empty argument, as an unset variable of a shell leaves it, is refused at once by every command") {
    const Workplace work;
    const std::string scene = work.write("scene.json", scene_text);
    const std::string mesh = work.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string out = work.file("out");
    const std::vector<std::string> calls{
        "render '' -o " + out + ".png",
        "render " + scene + " -o ''",
        "render " + scene + " --method '' -o " + out + ".png",
        "render " + scene + " --kernel= -o " + out + ".png",
        "trace '' -o " + out + ".jsonl",
        "trace " + scene + " '' -o " + out + ".jsonl",
        "check ''",
        "check " + scene + " --list ''",
        "shrink '' -o " + out + ".json",
        "find '' -o " + out + ".json",
        "need ''",
        "choose ''",
        "map ''",
        "margin '' --step 1 --vertex A.0",
        "chart '' -o " + out + ".json",
        "replay '' -o " + out + ".png",
        "figure '' -o " + out + ".svg",
        "diff '' ''",
        "page '' -o " + out + ".html",
        "lesson check ''",
        "grade ''",
        "homework '' -o " + out,
        "worksheet '' -o " + out + ".pdf",
        "import " + mesh + " '' -o " + out + ".json",
        "import '' -o " + out + ".json",
        "stability --merge ''",
        "methods ''",
        "''",
    };
    for (const auto& call : calls) {
        CAPTURE(call);
        const Outcome outcome = shell("timeout 20 $vidno " + call);
        CHECK(outcome.status == 2);
        CHECK(outcome.text.find("is empty") != std::string::npos);
        CHECK_MESSAGE(work.files() == 2, "only the inputs");
    }
}

TEST_CASE("Output that cannot be written is an error of every command that prints") {
    const Workplace work;
    const std::string scene = work.write("scene.json", scene_text);
    const std::string run = work.file("run.jsonl");
    REQUIRE(program("trace " + scene + " -o " + run).status == 0);
    // The first sign of the run: that of a step with an orientation.
    const std::string text = work.read("run.jsonl");
    std::string step = "1";
    {
        int number = -1;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line); ++number) {
            if (line.find("\"e\":\"orient\"") != std::string::npos ||
                line.find("\"e\":\"clip_sign\"") != std::string::npos) {
                step = std::to_string(number + 1);
                break;
            }
        }
    }
    const std::vector<std::string> calls{
        "check " + scene,
        "margin " + scene + " --step " + step + " --vertex A.0 --json",
        "need " + scene,
        "choose " + scene,
        "methods",
        "methods --json",
        "stability --count 1 --family triangles --kernel double --method zbuffer",
        "--help",
        "--version",
        "render --help",
        "describe bash",
        "describe manual",
        "render " + scene + " -o -",
        "trace " + scene + " -o -",
        "replay " + run + " -o -",
        "figure " + run + " -o -",
    };
    for (const auto& call : calls) {
        CAPTURE(call);
        const Outcome outcome = shell("$vidno " + call + " 2>&1 >/dev/full");
        CAPTURE(outcome.text);
        CHECK(outcome.status == 1);
        CHECK(outcome.text.find("standard output: cannot write") != std::string::npos);
    }
}

TEST_CASE("A full device for -o is an error, too") {
    const Workplace work;
    const std::string scene = work.write("scene.json", scene_text);
    const Outcome outcome = program("trace " + scene + " -o /dev/full");
    CHECK(outcome.status == 1);
    CHECK(outcome.text.find("/dev/full: cannot write: No space left on device") != std::string::npos);
}

TEST_CASE("A run that a signal ends leaves no unfinished file, and ends by the signal") {
    // A trace of many polygons takes longer than the time until the unfinished file appears, at which the signal is
    // sent.
    const Workplace work;
    std::string polygons;
    for (int i = 0; i < 3000; ++i) {
        const auto text = [](int number) { return std::to_string(number); };
        const int x = i % 50 * 10, y = i / 50 * 8;
        polygons += std::string(i > 0 ? "," : "") + "{\"vertices\":[[" + text(x) + "," + text(y) + ",0],[" +
                    text(x + 400) + "," + text(y) + ",0],[" + text(x) + "," + text(y + 300) + ",0]]}";
    }
    const std::string scene = work.write(
        "scene.json", R"({"window":{"x":0,"y":0,"width":2048,"height":2048},"polygons":[)" + polygons + "]}");
    const std::string wait_and_stop =
        "while kill -0 $pid && ! ls " + work.file("run.jsonl") + ".part-* >/dev/null 2>&1; do :; done; kill -";
    for (const int signal :
         {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGUSR1, SIGUSR2, SIGALRM, SIGXCPU, SIGVTALRM, SIGPROF}) {
        CAPTURE(signal);
        // In a background job of sh SIGINT and SIGQUIT are ignored; `env` restores them.
        const Outcome outcome =
            shell("env --default-signal=INT,QUIT $vidno trace " + scene + " -o " + work.file("run.jsonl") +
                  " & pid=$!; " + wait_and_stop + std::to_string(signal) + " $pid; wait $pid");
        CHECK(outcome.status == 128 + signal);
        CHECK(work.files() == 1);
    }
}

TEST_CASE("A number of events below 0 is refused in a short line") {
    const Workplace work;
    const std::string scene = work.write("scene.json", scene_text);
    const Outcome outcome = program("trace " + scene + " --max-events -1 -o " + work.file("a.jsonl"));
    CHECK(outcome.status == 2);
    CHECK(outcome.text.find("--max-events: -1 is not a whole number from 0") != std::string::npos);
    CHECK(outcome.text.size() < 120);
}

TEST_CASE("A campaign skips the scenes that a kernel cannot take, and counts them") {
    // The widest scenes of `grown` have 256 pixels a side: on a grid of 2^-18 these are 2^26 steps.
    const Workplace work;
    for (const std::string grid : {"grid:18", "grid:20"}) {
        CAPTURE(grid);
        const std::string file = work.file(grid.substr(5) + ".jsonl");
        const Outcome outcome = program("stability --count 1 --family triangles --kernel " + grid +
                                        " --kernel filtered " + "--method zbuffer --method warnock -o " + file);
        CAPTURE(outcome.text);
        CHECK(outcome.status == 0);
        CHECK(outcome.text.find("of zbuffer with scenes that are too wide for " + grid) != std::string::npos);
        CHECK(outcome.text.find("too wide for filtered") == std::string::npos);
        const Outcome merged = program("stability --merge " + file);
        CHECK(merged.status == 0);
        CHECK(merged.text.find("too wide for " + grid) != std::string::npos);
    }
}
