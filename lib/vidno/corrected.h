/// Corrected: Warnock's algorithm and the Z-buffer with the errors of the printed text corrected. The default set.
///
/// A procedure set is an object whose functions are the procedures; a run calls them through its set. Another set
/// derives from this one and hides the functions it changes: a whole procedure, or one of the rules below, in which
/// editions of the text differ. trace/FORMAT.md and `vidno methods` name the editions; printed.h lists the defects
/// (X-...), mistakes/ has the usual mistakes.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "corrected_polygons.h"
#include "method.h"
#include "warnock/fill_polygon.h"
#include "warnock/point_color.h"
#include "warnock/polygon_clip.h"
#include "warnock/process_window.h"
#include "warnock/surround_test.h"
#include "warnock/warnock.h"
#include "z_buffer/show_line.h"
#include "z_buffer/z_buffer.h"

namespace vidno {

struct Corrected : CorrectedPolygons,
                   Warnock,
                   ProcessWindow,
                   PointColor,
                   SurroundTest,
                   PolygonClip,
                   FillPolygon,
                   ZBuffer,
                   ShowLine {
    static constexpr std::string_view name = "corrected";

    /// The methods that `render` runs with this set.
    static constexpr auto methods = std::to_array({Method::warnock, Method::zbuffer});

    /// W3: the first window. A power-of-two square splits into whole pixels; parts off the area are skipped.
    static Window root_window(const Area& area) { return covering_square(area); }

    /// W13: the parts into which a window is split; together they cover it.
    static WindowParts parts(const Window& window) { return parts_of(window); }

    /// W13: the list of a part of a window: its own copy.
    template <class List>
    static std::shared_ptr<List> list_for_part(const std::shared_ptr<List>& list) {
        return std::make_shared<List>(*list);
    }

    /// PW1: the initial corner depth.
    static auto first_corner_depth(const auto& kernel) { return kernel.farthest(); }

    /// PW3: does a polygon leave the list?
    static bool discards(bool surrounding, bool outside) { return !surrounding && outside; }

    /// PW7: does a polygon that is nearest at k corners invalidate the surrounding one found before it?
    static bool uncovers(int k) { return k > 0; }

    /// PL2: the corners of a window, in the order in which a point with a positive cross product to a side lies
    /// outside.
    template <class K>
    static auto corners_around(const K& kernel, const Window& window) {
        return std::array{kernel.point(window.x, window.y), kernel.point(window.x, window.bottom()),
                          kernel.point(window.right(), window.bottom()), kernel.point(window.right(), window.y)};
    }

    /// PL5: do two cross products have strictly opposite signs?
    static bool opposite(const auto& kernel, const auto& p, const auto& q) {
        return kernel.sign(p) != Sign::zero && kernel.sign(p) == -kernel.sign(q);
    }

    /// Z1: the initial depth of a pixel; every depth is nearer.
    static auto first_depth(const auto& kernel) { return kernel.farthest(); }

    /// Z5: the y of a row's scanline: that of the centres of its pixels.
    static auto scanline(const auto& kernel, const auto& /*polygon*/, int row) { return kernel.centre(row); }

    /// Z16: the first row that an edge ending at y no longer reaches.
    static int row_after(const auto& kernel, const auto& y, int top, int bottom) {
        return kernel.first_centre(y, top, bottom);
    }

    /// L1: the end of the rows that are scanned.
    static int rows_end(const Area& area) { return area.bottom(); }

    /// L2: is a line skipped that would cover these columns?
    static bool misses(int first, int end) { return first >= end; }

    /// L3: how the depth changes along a line of one point.
    static auto slope_of_point(const auto& kernel, const auto& /*left*/, const auto& /*right*/) {
        return kernel.zero();
    }

    /// L4: the x at which a line is sampled in its first column.
    static auto start_of(const auto& run, const auto& /*left*/, int column) { return run.kernel.centre(column); }

    /// L4: the columns first <= x < end of a line: those whose centres lie between its ends, both included.
    static std::pair<int, int> columns_shown(const auto& run, int row, const auto& left, const auto& right,
                                             const auto& /*polygon*/) {
        return {run.kernel.first_column(left, row, run.area.x, run.area.right()),
                run.kernel.last_column(right, row, run.area.x, run.area.right()) + 1};
    }

    /// L6: does a depth replace the stored one?
    static bool shows(const auto& kernel, const auto& depth, const auto& stored, const Pixel& pixel) {
        return kernel.nearer(depth, stored, pixel);
    }
};

}  // namespace vidno
