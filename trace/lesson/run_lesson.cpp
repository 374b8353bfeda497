#include <algorithm>
#include <filesystem>
#include <set>

#include "check/checked_trace.h"
#include "choice/method.h"
#include "event_lines.h"
#include "import/import.h"
#include "lesson.h"
#include "output.h"
#include "refused.h"
#include "run/write_trace.h"
#include "scene/scene_json.h"
#include "scene/snapped_scene.h"

namespace vidno {

const LessonRun& Lesson::run(const std::string& name) const {
    return *std::find_if(runs.begin(), runs.end(), [&](const LessonRun& each) { return each.name == name; });
}

Method method_of(const LessonRun& run) { return method_named(run.method); }

namespace {

bool is_mesh(const std::string& file) { return !file.ends_with(".json"); }

/// What the scene of a mesh lacks, once for each file.
void add_losses(const Lesson& lesson, Problems& problems) {
    std::set<std::string> files;
    for (const LessonRun& run : lesson.runs) files.insert(lesson.file(run.scene));
    for (const std::string& file : files) {
        if (!is_mesh(file)) continue;
        for (const auto& [what, where] : import_mesh_file(file, {}).losses) {
            problems.push_back({file, 1, where + (where.empty() ? "" : ": ") + what});
        }
    }
}

}  // namespace

AnyScene scene_of(const Lesson& lesson, const LessonRun& run) {
    const std::string file = lesson.file(run.scene);
    if (run.of_curves()) return read_surface(read_text(file), file);
    AdmittedScene scene = is_mesh(file) ? import_mesh_file(file, {}).scene : read_scene(read_text(file), file).scene;
    if (const auto reason = refusal_of(method_of(run), scene)) {
        throw Refused(file + ": not for " + run.method + ": " + *reason);
    }
    return scene;
}

namespace {

void write_request(const auto& request, TraceWriter& writer, const LessonRun& run) {
    run.check ? write_checked_trace(request, writer) : write_trace(request, writer);
}

void trace_scene(const AdmittedScene& scene, const LessonRun& run, const TraceWriter::Write& write) {
    const AdmittedScene ran = run.kernel.snaps() ? snapped_scene(scene, run.kernel.parameter).scene : scene;
    TraceWriter writer(TraceHeader{method_of(run), run.edition, run.kernel.name(), run.detail, ran}, write);
    write_request(RunRequest{method_of(run), run.kernel, run.edition, ran, run.detail}, writer, run);
}
void trace_scene(const Surface& surface, const LessonRun& run, const TraceWriter::Write& write) {
    TraceWriter writer(FloatingHorizonHeader{run.edition, run.kernel.name(), run.detail, surface}, write);
    write_request(FloatingHorizonRequest{run.kernel, run.edition, surface.curves, run.detail}, writer, run);
}

}  // namespace

void trace_run(const AnyScene& scene, const LessonRun& run, const TraceWriter::Write& write) {
    std::visit([&](const auto& each) { trace_scene(each, run, write); }, scene);
}

std::string LessonRun::other_scene() const {
    const std::string stem = std::filesystem::path(scene).stem().string();
    return stem == "scene" ? "" : stem;
}

std::string LessonRun::trace_file(const std::string& lesson) const {
    std::string file = lesson + (other_scene().empty() ? "" : '.' + other_scene());
    for (const std::string& part :
         {method, kernel.name(), name_of(edition), std::string(detail_names[std::size_t(detail)])}) {
        file += '.' + part;
    }
    std::replace(file.begin(), file.end(), ':', '-');
    return file + (check ? ".checked.jsonl.gz" : ".jsonl.gz");
}

Steps run_lesson(const Lesson& lesson, Problems& problems,
                 const std::function<void(const LessonRun&, std::string_view)>& take) {
    Steps steps;
    add_losses(lesson, problems);
    for (const LessonRun& run : lesson.runs) {
        std::vector<PinSearch> searches;
        for (const Pin& pin : lesson.pins) {
            if (pin.run == run.name) searches.emplace_back(pin);
        }
        EventLines lines;
        trace_run(scene_of(lesson, run), run, [&](std::string_view text) {
            if (take) take(run, text);
            lines.take(text, [&](std::uint64_t step, std::string_view line) {
                for (auto& search : searches) search.hear(step, line);
            });
        });
        for (const auto& search : searches) {
            const auto& [name, line] = std::pair(search.pin().name, search.pin().line);
            if (search.step()) steps[name] = *search.step();
            const std::string objection = search.objection();
            if (objection.empty()) continue;
            problems.push_back({lesson.file("lesson.json"), line, "pin " + name + ": " + objection});
        }
    }
    return steps;
}

namespace {

using Json = nlohmann::ordered_json;

/// Adds what the lesson states of its frame.
void add_frame(Json& whole, const Frame& frame) {
    if (frame.minutes) whole["minutes"] = *frame.minutes;
    if (!frame.assumes.english.empty()) whole["assumes"] = object_of<Json>(frame.assumes);
    if (frame.prerequisites) {
        Json& lessons = whole["prerequisites"] = Json::array();
        for (const auto& [id, title] : *frame.prerequisites) {
            lessons.push_back({{"id", id}, {"title", object_of<Json>(title)}});
        }
    }
    if (frame.sources) {
        Json& sources = whole["sources"] = Json::array();
        for (const auto& [key, chapter] : *frame.sources) {
            Json source = frame.bibliography.at(key);
            if (!chapter.empty()) source["chapter"] = chapter;
            sources.push_back(std::move(source));
        }
    }
}

}  // namespace

std::string lesson_json(const Lesson& lesson, const Steps& steps, const InEachLanguage<Figures>& figures,
                        Answers answers) {
    Json traces = Json::object();
    for (const auto& run : lesson.runs) traces[run.name] = run.trace_file(lesson.id);
    Json pins = Json::object();
    for (const auto& pin : lesson.pins) {
        if (const auto step = steps.find(pin.name); step != steps.end()) {
            pins[pin.name] = {{"run", pin.run}, {"step", step->second}};
        }
    }
    const auto stories = in_each_language([&](Language language) {
        const Story& story = lesson.stories.in(language);
        Json blocks = story.blocks;
        if (answers == Answers::omitted) omit_answers(blocks);
        return Json{{"title", story.title},
                    {"goals", story.goals},
                    {"blocks", std::move(blocks)},
                    {"figures", figures.in(language)}};
    });
    Json whole{{"format", "vidno-lesson/1"},
               {"id", lesson.id},
               {"traces", traces},
               {"pins", pins},
               {"story", object_of<Json>(stories)}};
    if (!lesson.shows.empty()) whole["shows"] = lesson.shows;
    add_frame(whole, lesson.frame);
    return whole.dump();
}

}  // namespace vidno
