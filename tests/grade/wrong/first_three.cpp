// The Z-buffer, wrong: it computes the plane from the first three vertices, even if they lie on a line.
#include "../right/z_buffer_style.h"

struct FirstThree : PlainStyle {
    static std::vector<Sampled> pixels_of(const Polygon& polygon, const Area& area) {
        Polygon corner = polygon;
        corner.vertices.resize(3);
        std::vector<Sampled> all = PlainStyle::pixels_of(polygon, area);
        for (Sampled& each : all) each.z = depth(corner, {each.x + 0.5, each.y + 0.5});
        return all;
    }
};

int main() { run_as<FirstThree>("first_three.jsonl"); }
