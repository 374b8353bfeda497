// The Z-buffer, wrong: it uses at most four vertices of each polygon.
#include "../right/z_buffer_style.h"

struct FourVertices : PlainStyle {
    static std::vector<Sampled> pixels_of(Polygon polygon, const Area& area) {
        if (polygon.vertices.size() > 4) polygon.vertices.resize(4);
        return PlainStyle::pixels_of(polygon, area);
    }
};

int main() { run_as<FourVertices>("four_vertices.jsonl"); }
