/// Runs vidno's methods with some of their procedures replaced by your own, written in plain doubles. README.md beside
/// this file explains how. Needs C++20, vidno's headers, GLM and CGAL.
///
///     struct Mine {
///         static bool surround_test(Point point, const std::vector<Vertex>& polygon);
///     };
///     int main() { run_with<Mine>(vidno::Method::warnock, scene_to_draw(example_scene()), "mine.jsonl"); }
///
/// `Mine` has any of these, with these types. vidno's own procedures are used for the others:
///
///     Plane initialize_polygon(const std::vector<Vertex>& vertices)
///     double depth(const Plane& plane, Point point)
///     bool surround_test(Point point, const std::vector<Vertex>& polygon)
///     std::vector<Vertex> polygon_clip(const std::vector<Vertex>& polygon, const Rectangle& window)
#ifndef VIDNO_PROCEDURES_H
#define VIDNO_PROCEDURES_H

#include "run/recorder.h"
#include "vidno/admission.h"
#include "vidno/vidno.h"
#include "vidno_student.h"

// A student's program has no library to link, so it compiles these itself, in each file that includes this header.
#define VIDNO_INLINE inline
#include "format/event_text.cpp"
#include "json/json_text.cpp"

namespace vidno {
namespace student {

struct Point {
    double x, y;
};

/// a x + b y + c z + d = 0.
struct Plane {
    double a, b, c, d;
};

/// A window: from (x, y) to (x + width, y + height).
struct Rectangle {
    double x, y, width, height;
};

template <class Mine>
concept HasInitializePolygon = requires(const std::vector<Vertex>& vertices) {
    { Mine::initialize_polygon(vertices) } -> std::same_as<Plane>;
};
template <class Mine>
concept HasDepth = requires(const Plane& plane, Point point) {
    { Mine::depth(plane, point) } -> std::same_as<double>;
};
template <class Mine>
concept HasSurroundTest = requires(Point point, const std::vector<Vertex>& polygon) {
    { Mine::surround_test(point, polygon) } -> std::same_as<bool>;
};
template <class Mine>
concept HasPolygonClip = requires(const std::vector<Vertex>& polygon, const Rectangle& window) {
    { Mine::polygon_clip(polygon, window) } -> std::same_as<std::vector<Vertex>>;
};

/// The procedures of the lecture, some replaced by those of `Mine`.
template <class Mine>
struct SetOf : Corrected {
    static_assert(HasInitializePolygon<Mine> || HasDepth<Mine> || HasSurroundTest<Mine> || HasPolygonClip<Mine>,
                  "none of the procedures by name and types");

    static auto initialize_polygon(auto& run, const auto& vertices) {
        if constexpr (HasInitializePolygon<Mine>) {
            const auto [a, b, c, d] = Mine::initialize_polygon(plain(vertices));
            return vidno::Plane<double>{a, b, c, d};
        } else {
            return Corrected::initialize_polygon(run, vertices);
        }
    }
    static double depth(auto& run, const auto& polygon, const auto& point) {
        if constexpr (HasDepth<Mine>) {
            const auto& [a, b, c, d] = polygon.plane;
            return Mine::depth(Plane{a, b, c, d}, Point{point.x, point.y});
        } else {
            return Corrected::depth(run, polygon, point);
        }
    }
    static bool surround_test(auto& run, const auto& point, const auto& polygon) {
        if constexpr (HasSurroundTest<Mine>) {
            return Mine::surround_test(Point{point.x, point.y}, plain(polygon.vertices));
        } else {
            return Corrected::surround_test(run, point, polygon);
        }
    }
    static auto polygon_clip(auto& run, const auto& polygon, const auto& window) {
        if constexpr (HasPolygonClip<Mine>) {
            const Rectangle rectangle{window.x, window.y, window.width, window.height};
            std::vector<vidno::Vertex<double>> clipped;
            for (const auto& [x, y, z] : Mine::polygon_clip(plain(polygon.vertices), rectangle))
                clipped.push_back({x, y, z});
            return clipped;
        } else {
            return Corrected::polygon_clip(run, polygon, window);
        }
    }

private:
    static std::vector<Vertex> plain(const auto& vertices) {
        std::vector<Vertex> all;
        for (const auto& [x, y, z] : vertices) all.push_back({x, y, z});
        return all;
    }
};

/// The sink of vidno's recorder.
class ProcedureTrace final : public PolygonTrace, public EventSink {
public:
    /// `drawn` is the scene in vidno's own form.
    ProcedureTrace(const std::string& file, const std::string& name, const Scene& scene, const vidno::Scene& drawn)
        : PolygonTrace(file, name.c_str(), scene, Detail::signs, Precision::double_precision),
          events_(polygon_names(drawn)) {}

    void hear(const EventView& event) override {
        Text line;
        events_.line(line, event);
        tell_line(std::string(line.view().substr(0, line.size() - 1)));
    }
    void finish(const Picture& picture) {
        for (int y = area().y; y < area().y + area().height; ++y) {
            for (int x = area().x; x < area().x + area().width; ++x) {
                const auto [red, green, blue] = picture.at(x, y);
                paint({x, y, x + 1, y + 1}, {red, green, blue});
            }
        }
        close();
    }

private:
    EventText events_;
};

/// The scene in vidno's own form.
inline vidno::Scene for_vidno(const Scene& scene) {
    const auto color = [](const Color& c) {
        return vidno::Color{std::uint8_t(c.red), std::uint8_t(c.green), std::uint8_t(c.blue)};
    };
    vidno::Scene made{
        scene.name, {scene.area.x, scene.area.y, scene.area.width, scene.area.height}, color(scene.background), {}};
    for (const Polygon& polygon : scene.polygons) {
        made.polygons.push_back({polygon.id, color(polygon.color), {}, false});
        for (const Vertex& v : polygon.vertices) made.polygons.back().vertices.push_back({v.x, v.y, v.z});
    }
    return made;
}

/// Draws the scene by a method with the procedures of `Mine`, and writes the trace.
template <class Mine>
void run_with(Method method, const Scene& scene, const std::string& file) {
    const AdmittedScene drawn = admit(for_vidno(scene));
    ProcedureTrace trace(file, std::string(method_names[std::size_t(method)]), scene, drawn);
    Recording recording{vidno::Detail::signs, trace};
    trace.finish(render<SetOf<Mine>>(method, drawn, Double{}, Recorder<Double>(recording)));
}

}  // namespace student
}  // namespace vidno

#endif
