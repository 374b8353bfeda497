// The Z-buffer, right: it computes in float without lists of edges. A polygon includes its left and upper outline only.
#include "../course.h"

int main() {
    const Scene scene = scene_to_draw(example_scene());
    ZBufferTrace trace("half_open_float.jsonl", scene, Detail::signs, Precision::single_precision);
    const Area& area = scene.area;
    std::vector<float> depths(std::size_t(area.width * area.height), -1.5f);
    trace.clear(-1.5f);
    for (int i = 0; i < int(scene.polygons.size()); ++i) {
        const Polygon& polygon = scene.polygons[std::size_t(i)];
        if (is_edge_on(polygon)) continue;
        trace.polygon(i);
        const Plane plane = plane_of(polygon);
        const float dx = float(-plane.a / plane.c), dy = float(-plane.b / plane.c), z0 = float(-plane.d / plane.c);
        for (int row = area.y; row < area.y + area.height; ++row) {
            double left = 0, right = 0;
            if (!ends_on(polygon.vertices, row + 0.5, left, right)) continue;
            trace.scanline(row + 0.5, row);
            const int first = first_centre(float(left), area), end = first_centre(float(right), area);
            float z = z0 + dy * (float(row) + 0.5f) + dx * (float(first) + 0.5f);
            for (int x = first; x < end; ++x, z += dx) {
                float& stored = depths[std::size_t((row - area.y) * area.width + x - area.x)];
                trace.pixel(x, row, z, stored, z > stored);
                if (z > stored) stored = z;
            }
            trace.span();
        }
    }
}
