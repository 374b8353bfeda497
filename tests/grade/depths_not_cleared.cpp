// The Z-buffer, wrong: it does not fill the array of depths.
#include "course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace("depths_not_cleared.jsonl", scene);
    const int width = scene.area.width, height = scene.area.height;
    std::vector<double> buffer(std::size_t(width * height));
    for (int i = 0; i < int(scene.polygons.size()); ++i) {
        const Polygon& polygon = scene.polygons[std::size_t(i)];
        if (is_edge_on(polygon)) continue;
        trace.polygon(i);
        for (int row = 0; row < height; ++row) {
            const int y = scene.area.y + row;
            for (int column = 0; column < width; ++column) {
                const int x = scene.area.x + column;
                const Point centre{x + 0.5, y + 0.5};
                if (!holds(polygon, centre)) continue;
                const double z = depth(polygon, centre);
                double& old = buffer[std::size_t(row * width + column)];
                trace.pixel(x, y, z, old, z > old);
                if (z > old) old = z;
            }
            trace.span();
        }
    }
}
