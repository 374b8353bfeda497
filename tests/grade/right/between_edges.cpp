// The Z-buffer, right: it draws each row from the leftmost to the rightmost edge and steps the depth from pixel to
// pixel.
#include "z_buffer_style.h"

struct BetweenEdges : PlainStyle {
    static std::vector<Sampled> pixels_of(const Polygon& polygon, const Area& area) {
        std::vector<Sampled> all;
        const Plane plane = plane_of(polygon);
        for (int y = area.y; y < area.y + area.height; ++y) {
            double left = 0, right = 0;
            if (!ends_on(polygon.vertices, y + 0.5, left, right)) continue;
            const int first = first_centre(left, area);
            double z = depth(polygon, {first + 0.5, y + 0.5});
            for (int x = first; x < first_centre(right, area); ++x) {
                all.push_back({x, y, z});
                z -= plane.a / plane.c;
            }
        }
        return all;
    }
};

int main() { run_as<BetweenEdges>("between_edges.jsonl"); }
