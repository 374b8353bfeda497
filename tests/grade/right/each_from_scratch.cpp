// Another style, in `float`: no horizons are kept. Over each column they are found from all nearer curves and side
// edges, and each segment is drawn in parts as long as possible.
#include "example.h"

using namespace vidno::student;

struct Horizon {
    bool is;
    float upper, lower;
};

float on_line(const Sample& p, const Sample& q, float x) {
    return float(p.y) + (float(q.y) - float(p.y)) * (x - float(p.x)) / float(q.x - p.x);
}

class FromScratch {
public:
    FromScratch(const Surface& surface, FloatingHorizonTrace& trace) : curves_(surface.curves), trace_(trace) {
        for (std::size_t c = 0; c < curves_.size(); ++c) {
            trace.curve(int(c));
            for (std::size_t i = 1; i < curves_[c].size(); ++i) draw(c, curves_[c][i - 1], curves_[c][i]);
        }
    }

private:
    /// The horizon over a column before a curve.
    Horizon horizon(std::size_t curve, int x) const {
        Horizon found{false, 0, 0};
        const auto include = [&](float y) {
            found.upper = found.is ? std::min(found.upper, y) : y;
            found.lower = found.is ? std::max(found.lower, y) : y;
            found.is = true;
        };
        for (std::size_t c = 0; c < curve; ++c) {
            const std::vector<Sample>& samples = curves_[c];
            for (std::size_t i = 1; i < samples.size(); ++i) {
                if (samples[i - 1].x <= x && x <= samples[i].x) include(on_line(samples[i - 1], samples[i], float(x)));
            }
        }
        const auto include_edge = [&](const Sample& p, const Sample& q) {
            if (std::min(p.x, q.x) < x && x < std::max(p.x, q.x)) include(on_line(p, q, float(x)));
        };
        for (std::size_t c = 1; c <= curve; ++c) {
            include_edge(curves_[c - 1].front(), curves_[c].front());
            if (c < curve) include_edge(curves_[c - 1].back(), curves_[c].back());
        }
        return found;
    }

    /// The part 0 <= t <= 1 from x to x + 1 that is hidden.
    void hidden(std::size_t curve, const Sample& p, const Sample& q, int x, float& from, float& to) const {
        const Horizon first = horizon(curve, x), last = horizon(curve, x + 1);
        from = to = 1;
        if (!first.is || !last.is) return;
        const float y0 = on_line(p, q, float(x)), y1 = on_line(p, q, float(x + 1));
        from = 0;
        limit(y0 - first.upper, y1 - last.upper, from, to);
        limit(first.lower - y0, last.lower - y1, from, to);
        if (from >= to) from = to = 1;
    }
    /// Keeps the part where the function is positive that goes from f0 to f1.
    static void limit(float f0, float f1, float& from, float& to) {
        if (f0 <= 0 && f1 <= 0) to = from;
        if (f0 < 0 && f1 > 0) from = std::max(from, f0 / (f0 - f1));
        if (f0 > 0 && f1 < 0) to = std::min(to, f0 / (f0 - f1));
    }

    void draw(std::size_t curve, const Sample& p, const Sample& q) {
        float begin = float(p.x);
        for (int x = p.x; x < q.x; ++x) {
            float from = 1, to = 1;
            hidden(curve, p, q, x, from, to);
            if (from == to) continue;
            put(p, q, begin, float(x) + from);
            begin = float(x) + to;
        }
        put(p, q, begin, float(q.x));
    }
    void put(const Sample& p, const Sample& q, float from, float to) {
        if (from >= to) return;
        trace_.draw_line(from, on_line(p, q, from), to, on_line(p, q, to));
    }

    const std::vector<std::vector<Sample>>& curves_;
    FloatingHorizonTrace& trace_;
};

int main() {
    const Surface surface = surface_to_draw(example_surface());
    FloatingHorizonTrace trace("each_from_scratch.jsonl", surface, Detail::windows, Precision::single_precision);
    FromScratch(surface, trace);
}
