// Warnock's algorithm, right: a point is inside if a ray to the right crosses the outline an odd number of times. A
// window with a single polygon is split like any other.
#include "warnock_style.h"

struct RayCrossings : PlainStyle {
    static const bool draws_single = false;

    static bool contains(const Polygon& polygon, Point point) {
        bool inside = false;
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
            const Vertex &p = polygon.vertices[i], &q = polygon.vertices[(i + 1) % polygon.vertices.size()];
            if ((p.y <= point.y) == (q.y <= point.y)) continue;
            if (p.x + (point.y - p.y) * (q.x - p.x) / (q.y - p.y) > point.x) inside = !inside;
        }
        return inside;
    }
};

int main() { run_as<RayCrossings>("ray_crossings.jsonl"); }
