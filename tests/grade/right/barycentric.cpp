// The Z-buffer, right: a polygon is a fan of triangles, and a pixel's depth is the barycentric mean of the corners'
// depths.
#include "z_buffer_style.h"

struct Barycentric : PlainStyle {
    static std::vector<Sampled> pixels_of(const Polygon& polygon, const Area& area) {
        std::vector<Sampled> all;
        const Vertex& o = polygon.vertices[0];
        for (std::size_t i = 2; i < polygon.vertices.size(); ++i) {
            const Vertex &p = polygon.vertices[i - 1], &q = polygon.vertices[i];
            const double whole = cross({o.x, o.y}, {p.x, p.y}, {q.x, q.y});
            if (whole == 0) continue;
            for (int y = area.y; y < area.y + area.height; ++y) {
                for (int x = area.x; x < area.x + area.width; ++x) {
                    const Point c{x + 0.5, y + 0.5};
                    const double at_o = cross({p.x, p.y}, {q.x, q.y}, c) / whole;
                    const double at_p = cross({q.x, q.y}, {o.x, o.y}, c) / whole, at_q = 1 - at_o - at_p;
                    if (at_o >= 0 && at_p >= 0 && at_q >= 0)
                        all.push_back({x, y, at_o * o.z + at_p * p.z + at_q * q.z});
                }
            }
        }
        return all;
    }
};

int main() { run_as<Barycentric>("barycentric.jsonl"); }
