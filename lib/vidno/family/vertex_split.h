/// VertexSplit: the parts of a window on either side of a vertex in it, where detail is likely.
///
/// Windows consist of whole pixels: the split is at the pixel boundaries next to the vertex in x and y, if inside the
/// window.
///
/// Takes   a window of more than a pixel, and polygons.
/// Gives   its parts about the first vertex in it that has such a boundary, else about its middle.
#pragma once

#include <numeric>

#include "../run.h"

namespace vidno {

struct VertexSplit {
    template <class Run>
    static WindowParts split(Run& run, const Window& window,
                             const ActivePolygonList<typename Run::Arithmetic>& polygons) {
        using enum Line;
        auto& trace = run.trace;
        const auto& kernel = run.kernel;
        const int left = int(window.x), right = int(window.right());
        const int top = int(window.y), bottom = int(window.bottom());

        for (const auto& [polygon, surrounding] : polygons) {
            for (std::size_t i = 0; i < polygon->vertices.size(); ++i) {
                const auto& [x, y, z] = polygon->vertices[i];
                if (!kernel.inside({x, y, x, y}, window)) continue;
                const int column = kernel.first_centre(x, left, right);
                const int row = kernel.first_centre(y, top, bottom);
                const bool splits = (left < column && column < right) || (top < row && row < bottom);
                trace.split_vertex(VS2, *polygon, int(i), column, row, splits);
                if (splits) return parts_about(window, column, row);
            }
        }
        return parts_about(window, std::midpoint(left, right), std::midpoint(top, bottom));  // VS4
    }

private:
    /// The parts on either side of the first boundaries of a column and a row; fewer than four if one is a side of the
    /// window.
    static WindowParts parts_about(const Window& window, double column, double row) {
        WindowParts parts;
        for (const auto& [left, right] : {std::pair(window.x, column), std::pair(column, window.right())}) {
            for (const auto& [top, bottom] : {std::pair(window.y, row), std::pair(row, window.bottom())}) {
                if (left < right && top < bottom) parts.push_back({left, top, right - left, bottom - top});
            }
        }
        return parts;
    }
};

}  // namespace vidno
