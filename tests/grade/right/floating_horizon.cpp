// The floating horizon, as a student writes it for the course. The calls of `trace` report the steps to vidno.
//
//     floating_horizon [windows | polygons | signs]     writes floating_horizon.jsonl
#include "example.h"

using namespace vidno::student;

/// The height of a horizon over a column, if there is one.
struct Cell {
    bool is;
    double y;
};

struct Place {
    double x, y;
};

double height(const Sample& from, const Sample& to, int x) {
    if (x == from.x) return from.y;
    if (x == to.x) return to.y;
    return from.y + (x - from.x) * (to.y - from.y) / (to.x - from.x);
}

class FloatingHorizon {
public:
    FloatingHorizon(const Surface& surface, FloatingHorizonTrace& trace)
        : area_(surface.area),
          trace_(trace),
          upper_(std::size_t(area_.width), Cell{false, 0}),
          lower_(std::size_t(area_.width), Cell{false, 0}) {
        tell_start();
        for (std::size_t i = 0; i < surface.curves.size(); ++i) {
            const std::vector<Sample>& samples = surface.curves[i];
            trace.curve(int(i));
            if (i > 0) follow_edge(surface.curves[i - 1].front(), samples.front());
            trace.side_edge(samples.front().x, samples.front().y);
            draw_curve(samples);
            if (i > 0) follow_edge(surface.curves[i - 1].back(), samples.back());
            trace.side_edge(samples.back().x, samples.back().y);
        }
    }

private:
    void tell_start() {
        if (upper_[0].is) return trace_.horizons(upper_[0].y, lower_[0].y);
        trace_.horizons();
    }

    Cell& at(std::vector<Cell>& horizon, int x) const { return horizon[std::size_t(x - area_.x)]; }

    void follow_edge(const Sample& from, const Sample& to) {
        const int first = std::min(from.x, to.x) + 1, last = std::max(from.x, to.x) - 1;
        if (first <= last) raise(from, to, first, last);
    }

    /// Horizon
    void raise(const Sample& from, const Sample& to, int first, int last) {
        for (int x = first; x <= last; ++x) {
            const double y = height(from, to, x);
            Cell &upper = at(upper_, x), &lower = at(lower_, x);
            if (!upper.is || y < upper.y) {
                upper = {true, y};
                trace_.raise(x, y);
            }
            if (!lower.is || y > lower.y) {
                lower = {true, y};
                trace_.lower(x, y);
            }
        }
        trace_.horizon(first, last);
    }

    void draw_curve(const std::vector<Sample>& samples) {
        up_ = upper_;
        low_ = lower_;
        int flag = visibility(samples[0], samples[1], samples[0].x);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            const Sample &from = samples[i - 1], &to = samples[i];
            for (int x = from.x; x < to.x;) {
                const int next = x + 1;
                const int next_flag = visibility(from, to, next);
                draw_step(from, to, x, next, beside(flag, next_flag), beside(next_flag, flag));
                x = next;
                flag = next_flag;
            }
        }
    }

    int visibility(const Sample& from, const Sample& to, int x) {
        const double y = height(from, to, x);
        const Cell &upper = at(up_, x), &lower = at(low_, x);
        upper.is ? trace_.height(x, y, upper.y, lower.y) : trace_.height(x, y);
        const bool above = !upper.is || y <= upper.y, below = !lower.is || y >= lower.y;
        const int flag = above && below ? 2 : above ? 1 : below ? -1 : 0;
        trace_.visibility(x, flag);
        return flag;
    }

    /// On both horizons the curve is on the side where it goes on.
    static int beside(int flag, int other) { return flag != 2 ? flag : other == -1 ? -1 : 1; }

    void draw_step(const Sample& from, const Sample& to, int x, int next, int was, int is) {
        const Place first{double(x), height(from, to, x)}, last{double(next), height(from, to, next)};
        if (was == is) {
            if (is != 0) draw(from, to, first, last);
            return;
        }
        if (was != 0) draw(from, to, first, intersection(from, to, x, next, was));
        if (is != 0) draw(from, to, intersection(from, to, x, next, is), last);
    }

    void draw(const Sample& from, const Sample& to, Place first, Place last) {
        trace_.draw_line(first.x, first.y, last.x, last.y);
        raise(from, to, int(std::ceil(first.x)), int(std::floor(last.x)));
    }

    Place intersection(const Sample& from, const Sample& to, int first, int last, int side) {
        std::vector<Cell>& horizon = side == 1 ? up_ : low_;
        const auto reached = [&](int x) {
            const double y = height(from, to, x);
            const Cell& cell = at(horizon, x);
            return !cell.is || (side == 1 ? y <= cell.y : y >= cell.y);
        };
        Place met{double(last), height(from, to, last)};
        for (int x = first; x < last; ++x) {
            const bool changes = reached(x + 1) != reached(first);
            trace_.step(x + 1, changes);
            if (!changes) continue;
            met = crossing(x, height(from, to, x), height(from, to, x + 1), at(horizon, x), at(horizon, x + 1));
            break;
        }
        trace_.intersection(met.x, met.y);
        return met;
    }

    static Place crossing(int x, double y, double next_y, const Cell& left, const Cell& right) {
        if (!left.is || (right.is && next_y == right.y)) return {x + 1.0, next_y};
        if (!right.is || y == left.y) return {double(x), y};
        const double before = y - left.y, after = next_y - right.y, t = before / (before - after);
        return {x + t, y + (next_y - y) * t};
    }

    Area area_;
    FloatingHorizonTrace& trace_;
    std::vector<Cell> upper_, lower_;  // over the columns of the area
    std::vector<Cell> up_, low_;       // the same, before the current curve
};

int main(int count, char** words) {
    const Surface surface = surface_to_draw(example_surface());
    FloatingHorizonTrace trace("floating_horizon.jsonl", surface, detail_from(count, words));
    FloatingHorizon(surface, trace);
}
