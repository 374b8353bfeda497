/// FillPolygon: the pixels of a convex polygon, row by row. A primitive in the text; traced here.
///
/// Takes   vertices in order, perhaps none.
/// Gives   a run for each row that has one: the pixels of the area whose centres the closed polygon holds.
/// Time    an edge crossing for each row and edge.
#pragma once

#include "../run.h"

namespace vidno {

struct FillPolygon {
    template <class Run>
    static std::vector<PixelRun> fill_polygon(Run& run, const typename Run::Vertices& vertices) {
        using enum Line;
        auto& trace = run.trace;
        std::vector<PixelRun> runs;
        if (vertices.empty()) return runs;

        const auto box = box_around(vertices);
        const int first_row = run.kernel.first_centre(box.ymin, run.area.y, run.area.bottom());
        const int last_row = run.kernel.last_centre(box.ymax, run.area.y, run.area.bottom());
        for (int row = first_row; row <= last_row; ++row) {
            const auto [left, right] = run.kernel.crossings(vertices, run.kernel.centre(row));
            const int first = run.kernel.first_centre(left, run.area.x, run.area.right());
            const int end = run.kernel.last_centre(right, run.area.x, run.area.right()) + 1;
            trace.row(F2, row, left, right, first, end);
            if (first < end) runs.push_back({row, first, end});
        }
        return runs;
    }
};

}  // namespace vidno
