// Warnock's algorithm, right: a point is inside if the outline turns once around it or if it lies on the outline.
#include "warnock_style.h"

struct Angles : PlainStyle {
    static bool contains(const Polygon& polygon, Point point) {
        double turned = 0;
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
            const Vertex &p = polygon.vertices[i], &q = polygon.vertices[(i + 1) % polygon.vertices.size()];
            const double px = p.x - point.x, py = p.y - point.y, qx = q.x - point.x, qy = q.y - point.y;
            const double sine = px * qy - py * qx, cosine = px * qx + py * qy;
            if (sine == 0 && cosine <= 0) return true;
            turned += std::atan2(sine, cosine);
        }
        return std::abs(turned) > 3;
    }
};

int main() { run_as<Angles>("angles.jsonl"); }
