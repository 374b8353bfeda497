/// ShowLine as printed.
///
/// X-Z2  a line is rejected only if it lies both left of the area and right of it, that is, never.
/// X-Z3  the row and column just past the area are included: a write outside is reported as a fault and skipped.
/// X-Z4  a span of one point divides by zero.
/// X-Z5  x starts at a fractional x1: the painted pixels and their depths are off by up to a pixel.
/// X-Z7  the last polygon wins a tie.
/// X-Z9  a depth greater than 1 never shows.
#pragma once

#include "../fault.h"
#include "../run.h"

namespace vidno::printed {

/// One end of a line.
template <class Number>
struct SpanEnd {
    Number x, z;
};

struct ShowLine {
    template <class Run>
    static void show_line(Run& run, const typename Run::Number& y, const SpanEnd<typename Run::Number>& from,
                          const SpanEnd<typename Run::Number>& to, const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        using Number = typename Run::Number;
        auto& kernel = run.kernel;
        auto& trace = run.trace;
        const Number left_end = Number(run.area.x);
        const Number right_end = Number(run.area.right());
        const int row = kernel.pixel_of(y);
        trace.line(L1, row, from, to);
        if (y < run.area.y || y > run.area.bottom()) {
            trace.miss(L1);
            return;
        }
        if (to.x < left_end && from.x > right_end) {
            trace.miss(L2);
            return;
        }
        const Number dz = slope(kernel, from, to);
        trace.slope(L3, dz);
        Number x = from.x;
        Number z = from.z;
        if (x < left_end) {
            z += (left_end - x) * dz;
            x = left_end;
        }
        for (int steps = 0; x <= to.x && x <= right_end; ++steps) {
            if (steps > largest_side) throw Fault{L7, "more steps than any area has columns"};
            show_pixel(run, kernel.pixel_of(x), row, z, polygon.color);
            x += 1;
            z += dz;
        }
    }

    static auto slope(const auto& kernel, const auto& from, const auto& to) {
        try {
            return kernel.divide(to.z - from.z, to.x - from.x);
        } catch (const DivisionByZero&) {
            throw Fault{Line::L3, "division by zero"};
        }
    }

private:
    static void show_pixel(auto& run, int x, int y, const auto& z, const Color& color) {
        if (!run.area.contains(x, y)) {
            run.trace.fault(Line::L6, "outside the area", x, y);
            return;
        }
        auto& stored = run.depth_buffer.at(x, y);
        const auto kept = run.kernel.to_store(z);
        const auto depth = run.kernel.depth_of(kept);
        const bool shown = stored <= depth && z <= 1;
        run.trace.pixel(Line::L6, x, y, kept, stored, shown);
        if (!shown) return;
        stored = depth;
        run.picture.paint(x, y, color);
    }
};

}  // namespace vidno::printed
