/// Grade: runs a student's program on scenes, contained, judges each run, and finds the smallest scene that shows a
/// failure.
#pragma once

#include <algorithm>
#include <functional>

#include "grade/claim_counts.h"
#include "grade/mistakes.h"
#include "grade/scenes.h"
#include "grade/student_run.h"

namespace vidno {

struct SceneGrade {
    DrawnScene scene;
    StudentRun run;
    std::optional<Judgement> judgement{};  // none if there was nothing to judge
    std::string not_judged{};              // the reason in that case
    std::optional<Precision> judged_in{};  // none before it is judged

    bool right() const { return run.ended.ending == Ending::done && run.complete && judgement && !judgement->wrong; }
};

/// A fault that a run of the program reports.
struct ReportedFault {
    std::string scene;
    std::size_t step;
    std::string at, reason;
    std::size_t more;  // faults of the run after it
};

/// "step 12, L6: outside the area".
std::string in_words(const ReportedFault& fault, const Words& say);

struct ProgramGrade {
    std::vector<SceneGrade> scenes;
    std::size_t given = 0;  // the number of scenes that it was to draw
    Precision precision = Precision::twice;
    ClaimCounts claims;
    std::string missing;  // kinds of claims that the level asked for needs and no trace has; empty if none
    std::optional<Deviation> deviation;

    std::size_t wrong() const {
        return std::size_t(std::count_if(scenes.begin(), scenes.end(), [](const auto& each) { return !each.right(); }));
    }
    bool right() const { return wrong() == 0 && missing.empty(); }
    /// The first run with a false claim; if there is none, the first failure. Null if all runs are right.
    const SceneGrade* first_wrong() const;
    /// The first fault of each run that has one.
    std::vector<ReportedFault> faults() const;
};

/// Why a trace ends before its run does, in words.
std::string why_incomplete(const StudentRun& run, const Words& say);

/// How to run and judge.
struct Grading {
    Limits limits;
    Words say;
    Detail detail = Detail::windows;  // the traces must have the claims of that level
    bool first_only = false;          // stop at the first scene on which the program is wrong
};

/// Runs the program on the scenes of the kind that it draws in its first run, and judges the runs. Stops early after
/// two runs that exceed the limit of time. Calls `progress` before each run with the number of runs done. Throws
/// Refused if the program cannot be started.
ProgramGrade grade_program(const std::filesystem::path& program, const ScenesToGrade& scenes, const Grading& grading,
                           const std::function<void(std::size_t)>& progress);

/// Judges the text of an existing trace.
ProgramGrade grade_trace(std::string text, const Grading& grading);

/// When to stop making a scene smaller.
struct Patience {
    int runs = 300;
    std::chrono::seconds time{30};
};
/// The smallest scene found on which the program fails in the same way at no later step, with its run. Calls `progress`
/// before each run. Throws Refused if the program cannot be started.
SceneGrade smallest_failing(const std::filesystem::path& program, const SceneGrade& failing, Precision precision,
                            const Grading& grading, const Patience& patience, const std::function<void()>& progress);

}  // namespace vidno
