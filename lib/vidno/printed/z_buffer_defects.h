/// ZBufferDefects: the defects of the printed Z-buffer, one at a time, each as a change of the corrected text.
///
/// In the printed text (z_buffer.h, show_line.h) y is a number. Here a row is a whole number, so that a run has exactly
/// one defect.
#pragma once

#include <algorithm>
#include <utility>

#include "../corrected.h"
#include "show_line.h"

namespace vidno::printed {

struct ZBufferDefects : Corrected {
    /// X-Z1: an edge enters at the row to which its y rounds, and leaves at the first whole number not less than its y.
    static int row_after(const auto& kernel, const auto& y, int top, int bottom) {
        return kernel.first_centre(y + kernel.number(0.5), top, bottom);
    }

    /// X-Z2: a line cannot lie on both sides of the area.
    static bool misses(int /*first*/, int /*end*/) { return false; }

    /// X-Z3: the row and the column just past the area are scanned; a write there is a fault in the trace.
    static int rows_end(const Area& area) { return area.bottom() + 1; }
    static void show_line(auto& run, int row, const auto& left, const auto& right, const auto& polygon) {
        const auto& kernel = run.kernel;
        const Area& area = run.area;
        const bool past = row == area.bottom();
        past ? run.trace.line(Line::L1, row, left, right) : Corrected::show_line(run, row, left, right, polygon);
        const int first = kernel.first_column(left, row, past ? area.x : area.right(), area.right() + 1);
        const int last = kernel.last_column(right, row, first, area.right() + 1);
        for (int x = first; x <= last; ++x) run.trace.fault(Line::L6, "outside the area", x, row);
    }

    /// X-Z4: 0 is divided by 0.
    static auto slope_of_point(const auto& kernel, const auto& left, const auto& right) {
        return printed::ShowLine::slope(kernel, left, right);
    }

    /// X-Z5: a line starts at its left end, or at that of the area; each step goes one column to the right.
    static auto start_of(const auto& run, const auto& left, int /*column*/) {
        return std::max<typename std::decay_t<decltype(run)>::Number>(left.x, run.kernel.number(run.area.x));
    }
    static std::pair<int, int> columns_shown(const auto& run, int /*row*/, const auto& left, const auto& right,
                                             const auto& /*polygon*/) {
        const auto x = start_of(run, left, 0);
        const int first = run.kernel.pixel_of(x);
        const int end = right.x < x ? first : first + run.kernel.pixel_of(right.x - x) + 1;
        return {first, std::max(first, std::min(end, run.area.right()))};
    }

    /// X-Z6: the first scanline is at the polygon's ymin, wherever in a row that is.
    static auto scanline(const auto& kernel, const auto& polygon, int row) {
        const auto& y = polygon.box.ymin;
        return y + kernel.number(row - kernel.first_centre(y, -farthest_offset, farthest_offset));
    }

    /// X-Z7: the last of equally near polygons shows.
    static auto first_depth(const auto& kernel) { return kernel.depth_of(-1); }
    static bool shows(const auto& kernel, const auto& depth, const auto& stored, const Pixel& /*pixel*/) {
        return stored <= kernel.depth_of(depth);
    }
};

}  // namespace vidno::printed
