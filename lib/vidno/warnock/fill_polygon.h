/// FillPolygon: the pixels of a convex polygon, row by row. The text takes it for granted; here it is traced.
///
/// Takes   vertices in order, perhaps none.
/// Gives   a run of pixels for each row that has one: those of the area whose centres the closed polygon holds.
/// Time    one edge crossing for each row and edge.
#pragma once

#include "../run.h"

namespace vidno {

struct FillPolygon {
    template <class Run>
    static std::vector<PixelRun> fill_polygon(Run& run, const auto& vertices) {
        using enum Line;
        auto& trace = run.trace;
        std::vector<PixelRun> runs;
        if (vertices.empty()) return runs;

        const Rows rows = run.kernel.rows_of(vertices, run.area.y, run.area.bottom());
        for (int row = rows.first; row < rows.end; ++row) {
            const auto [left, right, first, end] = run.kernel.columns_of(vertices, row, run.area.x, run.area.right());
            trace.row(F2, row, left, right, first, end);
            if (first < end) runs.push_back({row, first, end});
        }
        return runs;
    }
};

}  // namespace vidno
