/// Grade: a student's program on scenes, each run contained and judged; and the smallest scene on which it is still so wrong.
#pragma once

#include <algorithm>
#include <functional>

#include "grade/mistakes.h"
#include "grade/student_run.h"
#include "grade/told.h"

namespace vidno {

struct SceneGrade {
    Scene scene;
    StudentRun run;
    std::optional<Judgement> judgement{};  // none if there was nothing to be judged
    std::string not_judged{};              // why, in that case

    bool right() const { return run.ended.ending == Ending::done && run.complete && judgement && !judgement->wrong; }
};

struct ProgramGrade {
    std::vector<SceneGrade> scenes;
    Precision precision = Precision::twice;
    ClaimsTold told;
    std::string missing;  // what of the level that was asked for is not told; empty if nothing is
    std::optional<Deviation> deviation;

    std::size_t wrong() const {
        return std::size_t(std::count_if(scenes.begin(), scenes.end(), [](const auto& each) { return !each.right(); }));
    }
    bool right() const { return wrong() == 0 && missing.empty(); }
    /// The first failure that says what is wrong; else the first of all. Null if there is none.
    const SceneGrade* first_wrong() const;
};

/// How to run and judge.
struct Grading {
    Limits limits;
    Words say;
    Detail detail = Detail::windows;  // claims of that level must be told
    bool first_only = false;          // stop at the first scene on which it is wrong
};

/// Runs the program on the scenes. A program that does not end on two of them is not run on those after. Throws Refused if it cannot be
/// started.
ProgramGrade grade_program(const std::filesystem::path& program, const std::vector<Scene>& scenes,
                           const Grading& grading, const std::function<void(std::size_t)>& progress);

/// Judges a trace that was written before.
ProgramGrade grade_trace(std::string text, const Grading& grading);

/// The smallest scene on which the program fails in the same way, at no later step, its run with it. Gives up making it smaller after so many
/// runs or so long. `progress` is called before each run.
struct Patience {
    int runs = 300;
    std::chrono::seconds time{30};
};
SceneGrade smallest_failing(const std::filesystem::path& program, const SceneGrade& failing, Precision precision,
                            const Grading& grading, const Patience& patience, const std::function<void()>& progress);

}  // namespace vidno
