// Your own procedure in one of vidno's runs: does a polygon hold a point? It counts edges, as in some books.
#include "example.h"
#include "vidno_procedures.h"

using namespace vidno::student;

struct Mine {
    /// True if a ray to the right crosses the outline an odd number of times. An edge includes its upper end but not
    /// its lower one.
    static bool surround_test(Point point, const std::vector<Vertex>& polygon) {
        bool inside = false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vertex &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
            if ((p.y <= point.y) == (q.y <= point.y)) continue;
            if (p.x + (point.y - p.y) * (q.x - p.x) / (q.y - p.y) > point.x) inside = !inside;
        }
        return inside;
    }
};

int main() { run_with<Mine>(vidno::Method::warnock, scene_to_draw(example_scene()), "surround_test.jsonl"); }
