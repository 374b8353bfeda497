/// Grade: a student's program on scenes, each run contained and judged; and the smallest scene on which it is still so wrong.
#pragma once

#include <functional>

#include "grade/mistakes.h"
#include "grade/student_run.h"

namespace vidno {

struct SceneGrade {
    Scene scene;
    StudentRun run;
    std::optional<Judgement> judgement;  // none if there was nothing to be judged
    std::string not_judged;              // why, in that case

    bool right() const { return run.ended.ending == Ending::done && run.complete && judgement && !judgement->wrong; }
};

/// Throws Refused if the program cannot be started.
SceneGrade grade_scene(const std::filesystem::path& program, const Scene& scene, const Limits& limits);

/// Judges a trace that was written before.
SceneGrade grade_trace(std::string text);

/// Which usual mistake the program behaves like.
std::optional<Edition> usual_mistake(const std::vector<SceneGrade>& grades);

/// The smallest scene on which the program fails in the same way, at no later step, its run with it. Gives up making it smaller after so many
/// runs or so long. `progress` is called before each run.
struct Patience {
    int runs = 300;
    std::chrono::seconds time{30};
};
SceneGrade smallest_failing(const std::filesystem::path& program, const SceneGrade& failing, const Limits& limits,
                            const Patience& patience, const std::function<void()>& progress);

}  // namespace vidno
