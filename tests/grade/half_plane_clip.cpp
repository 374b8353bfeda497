// A student's procedure in a run of vidno, wrong: polygon_clip forgets the lower side of the window.
#include "example.h"
#include "vidno_procedures.h"

using namespace vidno::student;

struct Mine {
    static std::vector<Vertex> polygon_clip(const std::vector<Vertex>& polygon, const Rectangle& window) {
        std::vector<Vertex> part = polygon;
        part = half(part, [&](const Vertex& v) { return v.x - window.x; });
        part = half(part, [&](const Vertex& v) { return window.x + window.width - v.x; });
        return half(part, [&](const Vertex& v) { return v.y - window.y; });
    }

    static std::vector<Vertex> half(const std::vector<Vertex>& polygon, const auto& inward) {
        std::vector<Vertex> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vertex &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
            const double a = inward(p), b = inward(q);
            if (a >= 0) kept.push_back(p);
            if (a * b >= 0) continue;
            const double t = a / (a - b);
            kept.push_back({p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, p.z + (q.z - p.z) * t});
        }
        return kept;
    }
};

int main() { run_with<Mine>(vidno::Method::warnock, scene_to_draw(example_scene()), "half_plane_clip.jsonl"); }
