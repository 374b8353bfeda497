/// Run: one execution of a method: its procedure set, kernel and visitor, the polygons, and the picture so far.
///
/// A procedure calls another through the run and names its own line. The set decides which text is executed, and the
/// call reports the result to the trace. So your own set is traced like ours.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "depth_buffer.h"
#include "fault.h"
#include "picture.h"
#include "polygon.h"
#include "trace.h"

namespace vidno {

template <Kernel K>
struct ActivePolygon {
    const Polygon<K>* polygon;
    bool surrounding;
};

/// APL: the polygons that may show in a window, in the order of the scene.
template <Kernel K>
using ActivePolygonList = std::vector<ActivePolygon<K>>;

/// An entry of the stack AW. In the printed text windows may share one list.
template <Kernel K>
struct ActiveWindow {
    Window window;
    std::shared_ptr<ActivePolygonList<K>> polygons;
};

/// The result of ProcessWindow.
struct WindowSummary {
    int polygon_count = 0;
    bool has_surround = false;
    Color color;  // of the surrounding polygon, if there is one
    bool insider = false;
};

template <class ProcedureSet, Kernel K, class Trace>
struct Run {
    using Set = ProcedureSet;
    using Arithmetic = K;
    using Number = typename K::Number;
    using Depth = typename K::Depth;
    using Interpolated = typename K::Interpolated;
    using Place = Point<typename K::Coordinate>;
    using Vertices = std::vector<Vertex<typename K::Coordinate>>;
    using Outline = typename K::Outline;

    [[no_unique_address]] Set set;
    K kernel;
    Trace trace;
    Area area;
    Color background;
    Picture& picture;
    std::vector<Polygon<K>> polygons;
    typename K::DepthBuffer depth_buffer;
    double smallest_window = 1;  // the side at which a window gets one colour (W9); in the text, a pixel

    Run(const Scene& scene, K arithmetic, Trace visitor, Picture& canvas, Set procedures = {})
        : set(std::move(procedures)),
          kernel(std::move(arithmetic)),
          trace(std::move(visitor)),
          area(scene.area),
          background(scene.background),
          picture(canvas) {
        kernel.see(scene);
        polygons.reserve(scene.polygons.size());
        for (const auto& source : scene.polygons) polygons.push_back(initialize_polygon(source));
    }

    Polygon<K> initialize_polygon(const ScenePolygon& source) {
        auto polygon = polygon_on_screen<Polygon<K>>(set, kernel, area, source, int(polygons.size()));
        polygon.plane = kernel.plane(set.initialize_polygon(*this, polygon.vertices), polygon.vertices);
        trace.plane(Line::I1, polygon, polygon.plane);
        return polygon;
    }

    WindowSummary process_window(Line at, const Window& window, ActivePolygonList<K>& active_polygons) {
        trace.call(at, Procedure::process_window);
        const WindowSummary summary = set.process_window(*this, window, active_polygons);
        trace.summary(at, summary);
        return summary;
    }

    Color point_color(Line at, const Place& point, const ActivePolygonList<K>& active_polygons) {
        trace.call(at, Procedure::point_color);
        const Color color = set.point_color(*this, point, active_polygons);
        trace.color(at, point, color);
        return color;
    }

    Depth depth(Line at, const Polygon<K>& polygon, const auto& point) {
        const Depth z = set.depth(*this, polygon, point);
        trace.depth(at, polygon, point, z);
        return z;
    }

    bool surround_test(Line at, const Place& point, const Polygon<K>& polygon) {
        trace.call(at, Procedure::surround_test);
        const bool inside = set.surround_test(*this, point, polygon);
        trace.surround(at, polygon, point, inside);
        return inside;
    }

    Outline polygon_clip(Line at, const Polygon<K>& polygon, const Window& window) {
        trace.call(at, Procedure::polygon_clip);
        const Outline vertices = set.polygon_clip(*this, polygon, window);
        trace.clip_result(at, polygon, vertices);
        return vertices;
    }

    void fill_polygon(Line at, const auto& vertices, const Polygon<K>& polygon) {
        trace.call(at, Procedure::fill_polygon);
        const std::vector<PixelRun> runs = set.fill_polygon(*this, vertices);
        for (const auto& run : runs) picture.paint(run, polygon.color);
        trace.draw(at, polygon, runs);
    }

    /// `row` is a row or, in the printed text, a y; an end has an x and a z.
    void show_line(Line at, const auto& row, const auto& from, const auto& to, const Polygon<K>& polygon) {
        trace.call(at, Procedure::show_line);
        try {
            set.show_line(*this, row, from, to, polygon);
        } catch (const Fault&) {
            trace.span(at);  // what was painted before
            throw;
        }
        trace.span(at);
    }

    void fill(Line at, const Window& window, Color color) {
        const PixelRectangle pixels = picture.pixels_of(window);
        picture.paint(pixels, color);
        trace.fill(at, pixels, color);
    }
};

}  // namespace vidno
