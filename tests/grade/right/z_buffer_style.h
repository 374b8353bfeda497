// A template of the Z-buffer. `Style` gives the pixels of a polygon, their order, and the depths there.
#ifndef Z_BUFFER_STYLE_H
#define Z_BUFFER_STYLE_H

#include "../course.h"

/// A pixel of a polygon and the polygon's depth at its centre.
struct Sampled {
    int x, y;
    double z;
};

template <class Style>
void run_as(const std::string& file) {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace(file, scene);
    const Area& area = scene.area;
    std::vector<double> depths(std::size_t(area.width * area.height), Style::start());
    trace.clear(Style::start());
    const int count = int(scene.polygons.size());
    for (int k = 0; k < count; ++k) {
        const int i = Style::backwards ? count - 1 - k : k;
        const Polygon& polygon = scene.polygons[std::size_t(i)];
        if (is_edge_on(polygon)) continue;
        trace.polygon(i);
        int row = area.y - 1;
        for (const Sampled& each : Style::pixels_of(polygon, area)) {
            if (each.x < area.x || each.x >= area.x + area.width || each.y < area.y || each.y >= area.y + area.height)
                continue;
            if (row >= area.y && each.y != row) trace.span();
            row = each.y;
            double& stored = depths[std::size_t((each.y - area.y) * area.width + each.x - area.x)];
            trace.pixel(each.x, each.y, each.z, stored, each.z > stored);
            stored = std::max(stored, each.z);
        }
        if (row >= area.y) trace.span();
    }
}

struct PlainStyle {
    static const bool backwards = false;
    static double start() { return farthest; }

    /// Tests every pixel of the area.
    static std::vector<Sampled> pixels_of(const Polygon& polygon, const Area& area) {
        std::vector<Sampled> all;
        for (int y = area.y; y < area.y + area.height; ++y) {
            for (int x = area.x; x < area.x + area.width; ++x) {
                if (holds(polygon, {x + 0.5, y + 0.5})) all.push_back({x, y, depth(polygon, {x + 0.5, y + 0.5})});
            }
        }
        return all;
    }
};

#endif
