// The Z-buffer, wrong: the depths start at -1, so polygons at that depth never show. It does not report the start
// depth.
#include "../course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace("starts_at_minus_one.jsonl", scene);
    const Area& area = scene.area;
    std::vector<double> depths(std::size_t(area.width * area.height), -1);
    for (int i = 0; i < int(scene.polygons.size()); ++i) {
        const Polygon& polygon = scene.polygons[std::size_t(i)];
        if (is_edge_on(polygon)) continue;
        trace.polygon(i);
        for (int y = area.y; y < area.y + area.height; ++y) {
            for (int x = area.x; x < area.x + area.width; ++x) {
                if (!holds(polygon, {x + 0.5, y + 0.5})) continue;
                const double z = depth(polygon, {x + 0.5, y + 0.5});
                double& stored = depths[std::size_t((y - area.y) * area.width + x - area.x)];
                if (z <= stored) continue;
                trace.pixel(x, y, z, stored, true);
                stored = z;
            }
            trace.span();
        }
    }
}
