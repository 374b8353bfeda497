// The Z-buffer, wrong: a pixel counts as inside only if its centre is strictly inside, by the signs of cross products.
#include "course.h"

/// Whether the cross products with all edges have the same sign, with none 0.
bool inside(const Polygon& polygon, Point p) {
    int positive = 0, negative = 0, edges = 0;
    const std::vector<Vertex>& v = polygon.vertices;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Vertex& w = v[(i + 1) % v.size()];
        if (v[i].x == w.x && v[i].y == w.y) continue;  // a repeated vertex
        ++edges;
        const double product = cross({v[i].x, v[i].y}, {w.x, w.y}, p);
        positive += product > 0;
        negative += product < 0;
    }
    return positive == edges || negative == edges;
}

int main() {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace("boundary_outside.jsonl", scene);
    const Area& area = scene.area;
    std::vector<double> z_buffer(std::size_t(area.width * area.height), farthest);
    trace.clear(farthest);
    for (int i = 0; i < int(scene.polygons.size()); ++i) {
        const Polygon& polygon = scene.polygons[std::size_t(i)];
        trace.polygon(i);
        for (int y = area.y; y < area.y + area.height; ++y) {
            for (int x = area.x; x < area.x + area.width; ++x) {
                const Point centre{x + 0.5, y + 0.5};
                if (!inside(polygon, centre)) continue;
                double& stored = z_buffer[std::size_t((y - area.y) * area.width + (x - area.x))];
                const double z = depth(polygon, centre);
                trace.pixel(x, y, z, stored, z > stored);
                stored = std::max(stored, z);
            }
            trace.span();
        }
    }
}
