// The Z-buffer, wrong: the smaller depth wins, as if the viewer looked in the direction of z.
#include "../course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace("depth_sign_reversed.jsonl", scene);
    const Area& area = scene.area;
    const double far_away = 1000;
    std::vector<std::vector<double>> depths(std::size_t(area.height),
                                            std::vector<double>(std::size_t(area.width), far_away));
    trace.clear(far_away);
    for (int i = 0; i < int(scene.polygons.size()); ++i) {
        const Polygon& polygon = scene.polygons[std::size_t(i)];
        if (is_edge_on(polygon)) continue;
        trace.polygon(i);
        for (int row = 0; row < area.height; ++row) {
            double left = 0, right = 0;
            const double y = area.y + row + 0.5;
            if (!ends_on(polygon.vertices, y, left, right)) continue;
            trace.scanline(y, area.y + row);
            for (int x = first_centre(left, area); x < first_centre(right, area); ++x) {
                const double z = depth(polygon, {x + 0.5, y});
                double& stored = depths[std::size_t(row)][std::size_t(x - area.x)];
                trace.pixel(x, area.y + row, z, stored, z < stored);
                stored = std::min(stored, z);
            }
            trace.span();
        }
    }
}
