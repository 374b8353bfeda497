#include "grade/grade.h"

#include "choice/method.h"
#include "stability/shrink.h"

namespace vidno {

namespace {

/// Why a run gives nothing to judge; empty if it does.
std::string nothing_to_judge(const StudentRun& run, const Scene& scene) {
    if (run.trace.empty()) {
        return "no trace was written: draw scene_to_draw(...), and tell a WarnockTrace or ZBufferTrace what you do";
    }
    if (!run.header) return run.unreadable;
    if (!is_of_course(run.header->method)) {
        return "a trace of " + std::string(method_names[std::size_t(run.header->method)]) +
               ": only warnock and zbuffer are judged";
    }
    if (run.header->kernel != "float" && run.header->kernel != "double") {
        return "a trace of the kernel " + run.header->kernel + ": only float and double are judged";
    }
    if (!same_scene(run.header->scene, scene)) {
        return "another scene was drawn than the one that was given: draw scene_to_draw(...)";
    }
    return "";
}

SceneGrade graded(const Scene& scene, StudentRun run) {
    SceneGrade grade{scene, std::move(run), std::nullopt, {}};
    grade.not_judged = nothing_to_judge(grade.run, scene);
    if (grade.not_judged.empty()) grade.judgement = judge(*grade.run.header, grade.run.events, grade.run.complete);
    return grade;
}

/// Whether b fails as a does, no later in the run.
bool fails_alike(const SceneGrade& a, const SceneGrade& b) {
    if (b.right() || a.run.ended.ending != b.run.ended.ending || a.judgement.has_value() != b.judgement.has_value())
        return false;
    if (!a.judgement || a.judgement->wrong.has_value() != b.judgement->wrong.has_value()) return !a.judgement;
    if (!a.judgement->wrong) return true;
    // A smaller scene that takes longer to show it would show it worse.
    return a.judgement->wrong->symptom == b.judgement->wrong->symptom &&
           b.judgement->wrong->step <= a.judgement->wrong->step;
}

}  // namespace

SceneGrade grade_scene(const std::filesystem::path& program, const Scene& scene, const Limits& limits) {
    return graded(scene, run_student(program, scene, limits));
}

SceneGrade grade_trace(std::string text) {
    StudentRun run = read_student_trace(std::move(text));
    const Scene scene = run.header ? run.header->scene : Scene{};
    return graded(scene, std::move(run));
}

std::optional<Edition> usual_mistake(const std::vector<SceneGrade>& grades) {
    std::vector<Observation> observed;
    for (const auto& each : grades) {
        if (each.judgement) observed.push_back({&*each.run.header, &*each.judgement, each.run.complete});
    }
    return usual_mistake(observed);
}

SceneGrade smallest_failing(const std::filesystem::path& program, const SceneGrade& failing, const Limits& limits,
                            const Patience& patience, const std::function<void()>& progress) {
    const auto deadline = std::chrono::steady_clock::now() + patience.time;
    SceneGrade smallest = failing;
    shrunk(failing.scene, [&, runs = 0](const Scene& smaller) mutable {
        if (++runs > patience.runs || std::chrono::steady_clock::now() > deadline) return false;
        progress();
        SceneGrade grade = grade_scene(program, smaller, limits);
        const bool alike = fails_alike(failing, grade);
        if (alike) smallest = std::move(grade);
        return alike;
    });
    return smallest;
}

}  // namespace vidno
