// What `say` says of runs that are wrong: what they computed, and what is so.

#include <doctest/doctest.h>

#include <string>

#include "support/workplace.h"

namespace {

/// The last line of a pixel's history in a run of a lesson's scene: why it has its colour.
std::string why(const std::string& scene, const std::string& options, const std::string& pixel,
                const std::string& language = "en") {
    const Workplace work;
    const std::string trace = work.file("run.jsonl");
    program("trace " VIDNO_ROOT "/lessons/" + scene + " --detail signs " + options + " -o " + trace);
    std::string text = program("say " + trace + " --pixel " + pixel + " --language " + language).text;
    text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

std::string said(const std::string& scene, const std::string& options) {
    const Workplace work;
    const std::string trace = work.file("run.jsonl");
    program("trace " VIDNO_ROOT "/lessons/" + scene + " --detail signs " + options + " -o " + trace);
    return program("say " + trace).text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

// A rises from −1/2 at x = 1 to 1/2 at x = 15: at x = 12.5 its depth is −1/2 + 11.5/14 = 9/28. As printed, all windows
// share one list, from which another window has removed A.
TEST_CASE("why a pixel has a wrong colour: what the run computed, what should show, and where the run goes wrong") {
    const std::string wrong = why("01-four-relations/cycle-16.json", "--edition printed", "12,12");
    CHECK_MESSAGE(wrong.starts_with("Why it has this colour: Computed: B is the nearest of all that cover its centre."),
                  wrong);
    CHECK_MESSAGE(has(wrong, "Exactly: pixel (12, 12) shows A, whose depth there is 9/28."), wrong);
    CHECK_MESSAGE(has(wrong, "The run goes wrong at step "), wrong);
    const std::string russian = why("01-four-relations/cycle-16.json", "--edition printed", "12,12", "ru");
    CHECK_MESSAGE(has(russian, "На самом деле: в пикселе (12; 12) виден A, его глубина там 9/28."), russian);
}

// At (13.5, 13.5) the depth of A is −1/2 + 12.5/14 = 11/28.
TEST_CASE("why a pixel is background though a polygon covers it") {
    const std::string wrong = why("01-four-relations/cycle-16.json", "--edition printed", "13,13");
    CHECK_MESSAGE(wrong.starts_with("Why it is background: Computed: no polygon covers its centre."), wrong);
    CHECK_MESSAGE(has(wrong, "Exactly: pixel (13, 13) shows A, whose depth there is 11/28."), wrong);
}

// I lies at depth 1/4, in front of S at −1/2.
TEST_CASE("a polygon that hides everything only as a mistake computes it is said to be computed") {
    const std::string text = said("01-four-relations/scene.json", "--edition surround-kept");
    CHECK(has(text,
              "Computed: S hides everything: the window takes its colour. Exactly: pixel (1, 1) shows I, whose depth "
              "there is 1/4."));
    const std::string wrong = why("01-four-relations/scene.json", "--edition surround-kept", "2,2");
    CHECK_MESSAGE(has(wrong, "Exactly: pixel (2, 2) shows I, whose depth there is 1/4."), wrong);
}

TEST_CASE("a number that a mistake computes is followed by the exact one") {
    const std::string text = said("01-four-relations/scene.json", "--edition depth-sign-reversed");
    CHECK(has(text, "Computed: At the top left corner the plane of S has depth 0.5. Exactly: its depth is −1/2."));
}

// On the plane of both, z rises by 1/128 with x and by 1/64 with y. At (20.5, 14.5) it is
// −9/32 + 18.5/128 + 9.5/64 = 3/256. A comes first in the scene.
TEST_CASE("a polygon that rounding finds nearer is said to be computed") {
    const std::string wrong = why("08-show-line/scene.json", "--method zbuffer --kernel float", "20,14");
    CHECK_MESSAGE(has(wrong, "Computed: B is nearer here than everything drawn before"), wrong);
    CHECK_MESSAGE(has(wrong, "Exactly: pixel (20, 14) shows A, whose depth there is 3/256."), wrong);
}

TEST_CASE("nothing is added where a run cannot be wrong") {
    for (const std::string kernel : {"exact", "filtered", "grid"}) {
        CHECK_MESSAGE(!has(said("08-show-line/scene.json", "--method zbuffer --kernel " + kernel), "Exactly"), kernel);
    }
}
