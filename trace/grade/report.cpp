#include "grade/report.h"

#include <algorithm>
#include <map>

#include "characters.h"

namespace vidno {

namespace {

std::string quoted(const std::string& name, const Words& say) {
    return name.empty() ? say({"a scene", "одна сцена"}) : say({"\"{}\"", "«{}»"}, escaped_for_terminal(name));
}

std::string place_of(const Wrong& wrong, const Words& say) {
    const std::string step = say({"step {}", "шаг {}"}, std::size_t(wrong.step));
    return step + (wrong.at.empty() ? "" : ", " + wrong.at);
}

/// Why a run is not right, in one line; empty if it is right.
std::string failure_of(const SceneGrade& grade, const Grading& grading) {
    const Words& say = grading.say;
    if (!grade.judgement) return grade.not_judged;
    std::string ended = grade.run.ended.ending == Ending::done ? "" : words_of(grade.run.ended, grading.limits, say);
    if (grade.judgement->wrong) return place_of(*grade.judgement->wrong, say) + (ended.empty() ? "" : "; ") + ended;
    if (!ended.empty()) return ended;
    return grade.run.complete ? "" : why_incomplete(grade.run, say);
}

/// A scene's line, with the verdict in its own column.
std::string line_of(const SceneGrade& grade, const std::string& failure, const Words& say) {
    const Bilingual verdict = !grade.judgement  ? Bilingual{"not judged ", "не проверено "}
                              : failure.empty() ? Bilingual{"right      ", "верно         "}
                                                : Bilingual{"wrong      ", "неверно       "};
    return "  " + say(verdict) + escaped_for_terminal(name_of(grade.scene)) + (failure.empty() ? "" : ": " + failure) +
           "\n";
}

std::string scenes_in_words(int count, const Words& say) {
    return say({count == 1 ? "{} scene" : "{} scenes", "сцен: {}"}, count);
}

/// How the right program differs from our procedures, and the pixels left open.
std::string differences_of(const ProgramGrade& grade, const Words& say) {
    std::map<Difference, int> scenes;
    int open = 0, open_scenes = 0;
    for (const auto& each : grade.scenes) {
        if (!each.judgement) continue;
        for (const Difference difference : each.judgement->differences) ++scenes[difference];
        open += each.judgement->open_places;
        open_scenes += int(each.judgement->open_places > 0);
    }
    // On scenes in which no window is split twice, breadth first cannot be distinguished from recursion.
    if (scenes.contains(Difference::breadth_first)) scenes.erase(Difference::recursion);
    std::string text;
    if (!scenes.empty()) text += say({"\nDifferent, but equally right:\n", "\nИначе, но тоже верно:\n"});
    for (const auto& [difference, count] : scenes)
        text += "  " + say(words_of(difference)) + " (" + scenes_in_words(count, say) + ")\n";
    if (open > 0) {
        const bool of_curves = std::holds_alternative<Surface>(grade.scenes.front().scene);
        text += say(
            of_curves
                ? Bilingual{"\nLeft open: {} columns ({}), where a curve is off a horizon by no more than {} rounds.\n",
                            "\nНе проверено: столбцов {} ({}), где кривая отстоит от горизонта не больше, чем "
                            "округляет {}.\n"}
                : Bilingual{"\nLeft open: {} pixels ({}), where two depths differ by no more than {} rounds.\n",
                            "\nНе проверено: пикселей {} ({}), где глубины различаются не больше, чем округляет "
                            "{}.\n"},
            open, scenes_in_words(open_scenes, say), grade.precision == Precision::single ? "float" : "double");
    }
    return text;
}

/// The faults that the traces report; empty if there are none.
std::string faults_in_words(const ProgramGrade& grade, const Words& say) {
    std::string text;
    for (const ReportedFault& fault : grade.faults()) {
        text += "  " + quoted(fault.scene, say) + ": " + in_words(fault, say);
        if (fault.more > 0) text += say({" (and {} more)", " (и ещё {})"}, fault.more);
        text += "\n";
    }
    if (text.empty()) return text;
    return say({"\nFaults that the trace reports:\n", "\nСбои, о которых сообщает запись:\n"}) + text;
}

/// The first lines that the program printed, indented.
std::string said_by(const std::string& said) {
    std::string text;
    std::size_t begin = 0;
    for (int lines = 0; lines < 5 && begin < said.size(); ++lines) {
        const std::size_t end = std::min(said.find('\n', begin), said.size());
        text += "    | " + said.substr(begin, end - begin) + '\n';
        begin = end + 1;
    }
    return text;
}

std::string details_of(const SceneGrade& grade, const Grading& grading) {
    const Words& say = grading.say;
    const StudentRun& run = grade.run;
    std::string text;
    if (run.ended.ending != Ending::done) {
        const std::string cause = cause_of(run.ended, say);
        text += say({"  The program {}", "  Программа {}"}, words_of(run.ended, grading.limits, say));
        if (!cause.empty()) text += ": " + cause;
        if (run.header)
            text += say({". The trace ends after step {}", ". Запись кончается после шага {}"}, run.events.size());
        text += ".\n";
    }
    if (grade.judgement && !grade.judgement->wrong && run.ended.ending == Ending::done && !run.complete)
        text += say({"  After step {} {}.\n", "  После шага {} {}.\n"}, run.events.size(), why_incomplete(run, say));
    if (!grade.judgement) text += say({"  Not judged: {}.\n", "  Не проверено: {}.\n"}, grade.not_judged);
    if (grade.judgement && grade.judgement->wrong) {
        const Wrong& wrong = *grade.judgement->wrong;
        text += "  " + place_of(wrong, say) + "\n" +
                say({"    the program: {}\n    but:         {}\n", "    программа: {}\n    но:        {}\n"},
                    wrong.claimed, wrong.right);
    }
    return text + said_by(run.ended.said);
}

/// The text of a report, which a student's program must not use to control the grader's terminal.
std::string without_controls(const std::string& text) { return escaped_for_terminal(text, "\n\t"); }

std::string verdict_of(const ProgramGrade& grade, const Words& say) {
    const int count = int(grade.scenes.size()), wrong = int(grade.wrong());
    const std::string claimed = in_words(grade.claims, say);
    if (wrong == 0 && count > 1)
        return say({"Right on all {} scenes, as far as reported: {}.\n",
                    "Верно на всех сценах ({}), насколько сообщено: {}.\n"},
                   count, claimed);
    if (wrong == 0) return say({"Right, as far as reported: {}.\n", "Верно, насколько сообщено: {}.\n"}, claimed);
    return say({"Wrong on {} of {}, first on {}:\n", "Неверно: {} из {}, впервые на сцене {}:\n"}, wrong, count,
               quoted(name_of(grade.first_wrong()->scene), say));
}

std::string in_words(const Area& area, const Words& say) {
    return say({"  area {}\n", "  область {}\n"}, PixelRectangle{area.x, area.y, area.width, area.height});
}

std::string in_words(const Scene& scene, const Words& say) {
    std::string text = in_words(scene.area, say);
    for (const auto& polygon : scene.polygons) {
        text += "  " + escaped_for_terminal(polygon.id);
        for (const auto& v : polygon.vertices) text += " " + say.point(v.x, v.y, v.z);
        text += "\n";
    }
    return text;
}

std::string in_words(const Surface& surface, const Words& say) {
    std::string text = in_words(surface.curves->area, say);
    int curve = 0;
    for (const auto& [samples] : surface.curves->curves) {
        text += say({"  curve {}", "  кривая {}"}, curve++);
        for (const auto& [x, y] : samples) text += " " + say.point(x, y);
        text += "\n";
    }
    return text;
}

}  // namespace

std::string report_of(const ProgramGrade& grade, const Grading& grading) {
    const Words& say = grading.say;
    std::string text = verdict_of(grade, say);
    if (const SceneGrade* first = grade.first_wrong()) text += details_of(*first, grading);
    if (!grade.missing.empty()) {
        text += say(
            {"\nNot reported, though level {} requires it: {}.\n", "\nНе сообщено, хотя требуется уровень {}: {}.\n"},
            detail_names[std::size_t(grading.detail)], grade.missing);
    }
    if (grade.deviation) text += "\n" + in_words(*grade.deviation, say) + "\n";
    text += faults_in_words(grade, say) + differences_of(grade, say) + "\n";
    std::string last;
    for (const auto& each : grade.scenes) {
        // A program that writes no trace fails on all scenes for the same reason.
        std::string failure = failure_of(each, grading);
        const bool is_repeated = !failure.empty() && failure == last;
        text += line_of(each, is_repeated ? say({"the same", "то же"}) : failure, say);
        last = std::move(failure);
    }
    if (grade.scenes.size() < grade.given) {
        text += say({"  Not run on the remaining {} scenes.\n", "  На остальных сценах ({}) не запускалась.\n"},
                    grade.given - grade.scenes.size());
    }
    return without_controls(text);
}

std::string report_of_smallest(const SceneGrade& smallest, const Grading& grading) {
    const Words& say = grading.say;
    const std::string heading =
        say({"\nThe smallest scene that shows it:\n", "\nНаименьшая сцена, на которой это видно:\n"});
    const std::string scene = std::visit([&](const auto& each) { return in_words(each, say); }, smallest.scene);
    return without_controls(heading + scene + details_of(smallest, grading));
}

}  // namespace vidno
