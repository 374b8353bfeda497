#include "grade/grade.h"

#include <algorithm>
#include <span>

#include "choice/method.h"
#include "scene/exact_scene.h"
#include "stability/shrink.h"

namespace vidno {

namespace {

bool is_judged(const AnyHeader& header) {
    const auto* polygons = std::get_if<TraceHeader>(&header);
    return !polygons || is_of_course(polygons->method) || polygons->method == Method::weiler_atherton;
}

/// Why a run cannot be judged; empty if it can.
std::string nothing_to_judge(const StudentRun& run, const DrawnScene& scene, const Words& say) {
    if (run.trace.empty()) {
        return say(
            {"no trace was written: draw scene_to_draw(...) or surface_to_draw(...), and report each step to a "
             "WarnockTrace, "
             "ZBufferTrace, WeilerAthertonTrace or FloatingHorizonTrace",
             "запись не создана: рисуйте scene_to_draw(...) или surface_to_draw(...) и сообщайте о шагах объекту "
             "WarnockTrace, ZBufferTrace, WeilerAthertonTrace или FloatingHorizonTrace"});
    }
    if (!run.header) return why_incomplete(run, say);
    if (!is_judged(*run.header)) {
        return say({"a trace of {}: only warnock, zbuffer, weiler-atherton and floating-horizon are judged",
                    "запись метода {}: проверяются только warnock, zbuffer, weiler-atherton и floating-horizon"},
                   method_of(*run.header));
    }
    const std::string& kernel = kernel_of(*run.header);
    if (kernel != "float" && kernel != "double") {
        return say({"a trace of the kernel {}: only float and double are judged",
                    "запись с арифметикой {}: проверяются только float и double"},
                   kernel);
    }
    if (!same_scene(scene_of(*run.header), scene)) {
        return say({"the program did not draw the given scene: draw scene_to_draw(...) or surface_to_draw(...)",
                    "нарисована другая сцена, а не заданная: рисуйте scene_to_draw(...) или surface_to_draw(...)"});
    }
    return "";
}

void judge_run(SceneGrade& grade, Precision precision, const Words& say) {
    if (grade.judged_in == precision) return;
    grade.judged_in = precision;
    grade.not_judged = nothing_to_judge(grade.run, grade.scene, say);
    if (grade.not_judged.empty())
        grade.judgement = judge(*grade.run.header, grade.run.events, grade.run.complete, precision, say);
}

/// Judges the runs of one program, and returns its precision: single if it says so, or if it tells only floats and some
/// of them were rounded to float. Numbers alone do not show it: those of a program in double are floats, too, if the
/// right ones are.
Precision judge_runs(std::span<SceneGrade> runs, const Words& say) {
    const auto says_single = [](const SceneGrade& each) {
        return each.run.header && kernel_of(*each.run.header) == "float";
    };
    const auto rounds = [](const SceneGrade& each) { return each.judgement && each.judgement->shows_single; };
    const auto judge_all = [&](Precision precision) {
        for (auto& each : runs) judge_run(each, precision, say);
        return precision;
    };
    if (std::any_of(runs.begin(), runs.end(), says_single)) return judge_all(Precision::single);
    judge_all(Precision::twice);
    const bool is_single =
        std::any_of(runs.begin(), runs.end(), rounds) &&
        std::all_of(runs.begin(), runs.end(), [](const SceneGrade& each) { return in_floats(each.run.events); });
    return is_single ? judge_all(Precision::single) : Precision::twice;
}

/// Judges all runs of one program. `given` is the number of scenes that it was to draw.
ProgramGrade judged(std::vector<SceneGrade> runs, std::size_t given, const Grading& grading) {
    ProgramGrade grade;
    grade.given = given;
    grade.precision = judge_runs(runs, grading.say);
    std::vector<Observation> observed;
    for (auto& each : runs) {
        if (!each.judgement) continue;
        observed.push_back({&*each.run.header, &each.run.events, &*each.judgement, each.run.complete});
        grade.claims += claim_counts(method_of(*each.run.header), each.run.events);
    }
    if (grading.detail != Detail::windows) grade.missing = missing_from(grade.claims, grading.detail, grading.say);
    grade.deviation = deviation_of(observed, grade.precision);
    grade.scenes = std::move(runs);
    return grade;
}

/// Whether b fails in the same way as a, at no later step.
bool fails_alike(const SceneGrade& a, const SceneGrade& b) {
    if (b.right() || a.run.ended.ending != b.run.ended.ending || a.judgement.has_value() != b.judgement.has_value())
        return false;
    if (!a.judgement || a.judgement->wrong.has_value() != b.judgement->wrong.has_value()) return !a.judgement;
    if (!a.judgement->wrong) return true;
    // A smaller scene with the false claim at a later step would be a worse example.
    return a.judgement->wrong->symptom == b.judgement->wrong->symptom &&
           b.judgement->wrong->step <= a.judgement->wrong->step;
}

}  // namespace

/// A text without a newline is a first line that was cut. The reader's reasons are English.
std::string why_incomplete(const StudentRun& run, const Words& say) {
    const bool is_cut_first_line = run.trace.starts_with('{') && run.trace.find('\n') == std::string::npos;
    if (run.unreadable.empty() || is_cut_first_line) return say({"the trace is cut short", "запись оборвана"});
    const std::size_t line = run.events.size() + 2;  // after that of the header
    return say({"the trace cannot be read: {}", "запись не читается в строке {1}"}, run.unreadable, line);
}

const SceneGrade* ProgramGrade::first_wrong() const {
    const auto tells = [](const SceneGrade& grade) { return grade.judgement && grade.judgement->wrong; };
    const auto fails = [](const SceneGrade& grade) { return !grade.right(); };
    auto found = std::find_if(scenes.begin(), scenes.end(), tells);
    if (found == scenes.end()) found = std::find_if(scenes.begin(), scenes.end(), fails);
    return found == scenes.end() ? nullptr : &*found;
}

std::string in_words(const ReportedFault& fault, const Words& say) {
    return say({"step {}, {}: {}", "шаг {}, {}: {}"}, fault.step, fault.at, say.reason(fault.reason));
}

std::vector<ReportedFault> ProgramGrade::faults() const {
    std::vector<ReportedFault> faults;
    for (const SceneGrade& each : scenes) {
        const auto& events = each.run.events;
        const auto is_fault = [](const Event& event) { return event.get_if<event::Fault>() != nullptr; };
        const auto first = std::find_if(events.begin(), events.end(), is_fault);
        if (first == events.end()) continue;
        const auto& fault = *first->get_if<event::Fault>();
        faults.push_back({name_of(each.scene), std::size_t(first - events.begin()) + 1,
                          std::string(line_names[std::size_t(fault.at)]), std::string(fault.reason),
                          std::size_t(std::count_if(std::next(first), events.end(), is_fault))});
    }
    return faults;
}

ProgramGrade grade_program(const std::filesystem::path& file, const ScenesToGrade& scenes, const Grading& grading,
                           const std::function<void(std::size_t)>& progress) {
    constexpr int enough_endless = 2;
    ContainedProgram program(file, grading.limits);
    std::vector<DrawnScene> polygons;
    for (const AdmittedScene& scene : scenes.polygons) polygons.emplace_back(*scene);
    const std::vector<DrawnScene> surfaces(scenes.surfaces.begin(), scenes.surfaces.end());
    const auto* drawn = polygons.empty() ? &surfaces : &polygons;
    std::vector<SceneGrade> runs;
    int endless = 0;
    while (runs.size() < drawn->size()) {
        progress(runs.size());
        const DrawnScene& scene = (*drawn)[runs.size()];
        const bool is_first = runs.empty() && !polygons.empty() && !surfaces.empty();
        StudentRun run = is_first ? run_student(program, {scene, surfaces.front()}) : run_student(program, {scene});
        if (is_first && run.header && std::holds_alternative<FloatingHorizonHeader>(*run.header)) drawn = &surfaces;
        runs.push_back({(*drawn)[runs.size()], std::move(run)});
        if (runs.back().run.ended.ending == Ending::out_of_time && ++endless == enough_endless) break;
        if (!grading.first_only) continue;
        judge_runs({&runs.back(), 1}, grading.say);
        if (!runs.back().right()) break;
    }
    return judged(std::move(runs), drawn->size(), grading);
}

ProgramGrade grade_trace(std::string text, const Grading& grading) {
    StudentRun run = read_student_trace(std::move(text));
    const DrawnScene scene = run.header ? scene_of(*run.header) : DrawnScene{};
    std::vector<SceneGrade> runs;
    runs.push_back({scene, std::move(run)});
    return judged(std::move(runs), 1, grading);
}

SceneGrade smallest_failing(const std::filesystem::path& file, const SceneGrade& failing, Precision precision,
                            const Grading& grading, const Patience& patience, const std::function<void()>& progress) {
    ContainedProgram program(file, grading.limits);
    const auto deadline = std::chrono::steady_clock::now() + patience.time;
    SceneGrade smallest = failing;
    auto fails = [&, runs = 0](const DrawnScene& smaller) mutable {
        if (++runs > patience.runs || std::chrono::steady_clock::now() > deadline) return false;
        progress();
        SceneGrade grade{smaller, run_student(program, {smaller})};
        judge_run(grade, precision, grading.say);
        const bool alike = fails_alike(failing, grade);
        if (alike) smallest = std::move(grade);
        return alike;
    };
    if (const auto* surface = std::get_if<Surface>(&failing.scene)) {
        shrunk(surface->curves, [&](const AdmittedCurves& smaller) { return fails(Surface{surface->name, smaller}); });
    } else {
        shrunk(exact_scene::admit(std::get<Scene>(failing.scene)),
               [&](const AdmittedScene& smaller) { return fails(Scene(smaller)); });
    }
    return smallest;
}

}  // namespace vidno
