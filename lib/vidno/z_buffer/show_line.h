/// ShowLine: the pixels of one scanline between two active edges, each kept if it is nearer than what is there.
///
/// Takes   a row, the two ends (x, z), and the polygon.
/// Gives   picture and depths changed at the pixel centres from the left end to the right, both included.
/// Time    an addition and a comparison a pixel; under rounding the depth drifts with every step.
#pragma once

#include "../run.h"

namespace vidno {

struct ShowLine {
    template <class Run>
    static void show_line(Run& run, int row, const SpanEnd<typename Run::Number>& left,
                          const SpanEnd<typename Run::Number>& right,
                          const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        using Number = typename Run::Number;
        auto& kernel = run.kernel;
        auto& trace = run.trace;
        trace.line(L1, row, left, right);

        int x = kernel.first_centre(left.x, run.area.x, run.area.right());
        const int end = kernel.last_centre(right.x, run.area.x, run.area.right()) + 1;
        if (x >= end) {
            trace.miss(L2);
            return;
        }
        const bool is_point = left.x == right.x;
        const Number dz = is_point ? Number(0) : Number((right.z - left.z) / (right.x - left.x));
        trace.slope(L3, dz);
        Number z = left.z + (kernel.centre(x) - left.x) * dz;
        trace.columns(L4, x, end, z);
        for (; x < end; ++x, z += dz) {
            auto& stored = run.depth_buffer.at(x, row);
            const bool nearer = kernel.nearer(z, stored);
            trace.pixel(L6, x, row, z, stored, nearer);
            if (!nearer) continue;
            stored = z;
            run.picture.paint(x, row, polygon.color);
        }
    }
};

}  // namespace vidno
