#include "grade/student_run.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "format/trace_reader.h"
#include "json/json_text.h"

namespace vidno {

namespace {

/// Writes the name on its own line, after a colon that preserves empty names and leading spaces.
void append_name(Text& text, const std::string& name) {
    text += ':';
    for (const char c : name) text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    text += '\n';
}

void append_numbers(Text& text, std::initializer_list<double> numbers) {
    for (const double each : numbers) {
        append_number(text, each);
        text += ' ';
    }
    text += '\n';
}

void append(Text& text, const Color& color) {
    append_numbers(text, {double(color.red), double(color.green), double(color.blue)});
}

using Places = std::vector<std::tuple<double, double, double>>;

Places sorted_vertices(const ScenePolygon& polygon) {
    Places places;
    for (const auto& v : polygon.vertices) places.emplace_back(v.x, v.y, v.z);
    std::sort(places.begin(), places.end());
    return places;
}

}  // namespace

std::string scene_text(const Scene& scene) {
    Text text;
    append_name(text, scene.name);
    const Area& area = scene.area;
    append_numbers(text, {double(area.x), double(area.y), double(area.width), double(area.height)});
    append(text, scene.background);
    append_numbers(text, {double(scene.polygons.size())});
    for (const auto& polygon : scene.polygons) {
        append_name(text, polygon.id);
        append(text, polygon.color);
        append_numbers(text, {double(polygon.vertices.size())});
        for (const auto& v : polygon.vertices) append_numbers(text, {v.x, v.y, v.z});
    }
    return text.string();
}

std::string scene_text(const Surface& surface) {
    Text text;
    append_name(text, surface.name);
    const Area& area = surface.curves->area;
    append_numbers(text, {double(area.x), double(area.y), double(area.width), double(area.height)});
    append_numbers(text, {double(surface.curves->curves.size())});
    for (const auto& [samples] : surface.curves->curves) {
        append_numbers(text, {double(samples.size())});
        for (const Sample& sample : samples) {
            if (sample.has_point()) {
                append_numbers(text, {double(sample.x), sample.y});
            } else {
                text += std::to_string(sample.x) + " nan\n";
            }
        }
    }
    return text.string();
}

DrawnScene scene_of(const AnyHeader& header) {
    return std::visit([](const auto& each) -> DrawnScene { return each.scene; }, header);
}

const std::string& name_of(const DrawnScene& scene) {
    return std::visit([](const auto& each) -> const std::string& { return each.name; }, scene);
}

StudentRun read_student_trace(std::string text) {
    StudentRun run;
    run.trace = std::move(text);
    try {
        AnyTraceReader any = open_trace(LineReader::of_text(run.trace), "trace");
        std::visit(
            [&](auto& reader) {
                run.header = reader.header();
                while (const auto event = reader.next()) run.events.push_back(event->copy());
                run.complete = reader.end() && !reader.end()->partial;
            },
            any);
    } catch (const Refused& refused) {
        run.unreadable = refused.what();
    }
    return run;
}

StudentRun run_student(ContainedProgram& program, const std::vector<DrawnScene>& scenes) {
    std::vector<FileOfRun> given;
    for (const DrawnScene& scene : scenes) {
        const bool is_surface = std::holds_alternative<Surface>(scene);
        given.push_back({is_surface ? "VIDNO_SURFACE" : "VIDNO_SCENE", is_surface ? "surface.txt" : "scene.txt",
                         std::visit([](const auto& each) { return scene_text(each); }, scene)});
    }
    Ended ended = program.run(given, {"VIDNO_TRACE", "trace.jsonl"});
    StudentRun run;
    if (!ended.written.empty()) run = read_student_trace(std::exchange(ended.written, {}));
    run.ended = std::move(ended);
    return run;
}

bool same_scene(const Scene& claimed, const Scene& given) {
    if (!(claimed.area == given.area) || claimed.background != given.background) return false;
    std::map<Places, int> surplus;
    for (const auto& polygon : claimed.polygons) ++surplus[sorted_vertices(polygon)];
    for (const auto& polygon : given.polygons) --surplus[sorted_vertices(polygon)];
    return std::all_of(surplus.begin(), surplus.end(), [](const auto& each) { return each.second == 0; });
}

bool same_scene(const DrawnScene& claimed, const DrawnScene& given) {
    if (claimed.index() != given.index()) return false;
    if (const auto* surface = std::get_if<Surface>(&claimed)) return surface->curves == std::get<Surface>(given).curves;
    return same_scene(std::get<Scene>(claimed), std::get<Scene>(given));
}

}  // namespace vidno
