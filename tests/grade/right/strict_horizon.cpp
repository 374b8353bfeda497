// Another style: the horizons start far beyond everything, a point on a horizon is hidden, and only lines are reported.
#include "example.h"

using namespace vidno::student;

const double far_away = 1e6;

struct Horizons {
    std::vector<double> upper, lower;

    void include(std::size_t column, double y) {
        upper[column] = std::min(upper[column], y);
        lower[column] = std::max(lower[column], y);
    }
};

/// The heights of a curve over its columns.
std::vector<double> heights_of(const std::vector<Sample>& samples) {
    std::vector<double> all{samples[0].y};
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const Sample &p = samples[i - 1], &q = samples[i];
        for (int x = p.x + 1; x < q.x; ++x) all.push_back(p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x));
        all.push_back(q.y);
    }
    return all;
}

void include_edge(Horizons& horizons, const Sample& p, const Sample& q, int left) {
    for (int x = std::min(p.x, q.x) + 1; x < std::max(p.x, q.x); ++x)
        horizons.include(std::size_t(x - left), p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x));
}

/// Draws the part of the line from x to x + 1 where it is above one line, or below it if `sign` is -1.
void draw_beyond(FloatingHorizonTrace& trace, int x, double y0, double y1, double h0, double h1, int sign) {
    const double before = sign * (h0 - y0), after = sign * (h1 - y1);
    if (before <= 0 && after <= 0) return;
    const double t = before / (before - after);
    const double from = before < 0 ? t : 0, to = after < 0 ? t : 1;
    trace.draw_line(x + from, y0 + (y1 - y0) * from, x + to, y0 + (y1 - y0) * to);
}

int main() {
    const Surface surface = surface_to_draw(example_surface());
    FloatingHorizonTrace trace("strict_horizon.jsonl", surface);
    const int left = surface.area.x;
    const std::size_t width = std::size_t(surface.area.width);
    Horizons horizons{std::vector<double>(width, far_away), std::vector<double>(width, -far_away)};
    const std::vector<Sample>* last = nullptr;
    int curve = 0;
    for (const std::vector<Sample>& samples : surface.curves) {
        trace.curve(curve++);
        if (last) include_edge(horizons, last->front(), samples.front(), left);
        const Horizons before = horizons;
        const std::vector<double> heights = heights_of(samples);
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const std::size_t column = std::size_t(samples[0].x - left) + i;
            horizons.include(column, heights[i]);
            if (i + 1 == heights.size()) break;
            const int x = samples[0].x + int(i);
            const bool empty = before.upper[column] == far_away || before.upper[column + 1] == far_away;
            draw_beyond(trace, x, heights[i], heights[i + 1], before.upper[column], before.upper[column + 1], 1);
            if (empty && before.upper[column] == before.upper[column + 1]) continue;  // all of it is drawn
            draw_beyond(trace, x, heights[i], heights[i + 1], before.lower[column], before.lower[column + 1], -1);
        }
        if (last) include_edge(horizons, last->back(), samples.back(), left);
        last = &samples;
    }
}
