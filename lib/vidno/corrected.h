/// Corrected: the procedures of the lecture with the errors of the printed text put right. The default set.
///
/// A procedure set is an object whose functions are the procedures; a run calls them through its set. Another set derives
/// from this one and hides what it does otherwise: a whole procedure, or one of the rules below, in which editions of the text
/// differ. trace/FORMAT.md and `vidno methods` name the editions; printed.h lists the defects (X-...), mistakes.h the usual
/// mistakes.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "floating_horizon/floating_horizon.h"
#include "floating_horizon/horizon.h"
#include "floating_horizon/intersection.h"
#include "floating_horizon/side_edge.h"
#include "floating_horizon/visibility.h"
#include "method.h"
#include "warnock/depth.h"
#include "warnock/fill_polygon.h"
#include "warnock/initialize_polygon.h"
#include "warnock/point_color.h"
#include "warnock/polygon_clip.h"
#include "warnock/process_window.h"
#include "warnock/surround_test.h"
#include "warnock/warnock.h"
#include "weiler_atherton/depth_sort.h"
#include "weiler_atherton/paint_regions.h"
#include "weiler_atherton/region_clip.h"
#include "weiler_atherton/remove_behind.h"
#include "weiler_atherton/split_piercing.h"
#include "weiler_atherton/weiler_atherton.h"
#include "z_buffer/show_line.h"
#include "z_buffer/z_buffer.h"

namespace vidno {

struct Corrected : Warnock,
                   ProcessWindow,
                   PointColor,
                   Depth,
                   SurroundTest,
                   PolygonClip,
                   InitializePolygon,
                   FillPolygon,
                   ZBuffer,
                   ShowLine,
                   FloatingHorizon,
                   SideEdge,
                   Visibility,
                   Horizon,
                   Intersection,
                   WeilerAtherton,
                   SplitPiercing,
                   DepthSort,
                   RegionClip,
                   RemoveBehind,
                   PaintRegions {
    static constexpr std::string_view name = "corrected";

    /// What `render` runs by this set.
    static constexpr auto methods = std::to_array({Method::warnock, Method::zbuffer});

    /// W2: which polygons join the first list. Edge-on was decided exactly when the scene was read.
    static bool takes_part(const auto&, const auto& polygon) { return !polygon.edge_on; }

    /// W3: the first window. A power-of-two square splits into whole pixels; parts off the area are skipped.
    static Window root_window(const Area& area) { return covering_square(area); }

    /// W13: the parts of a window: together they are the window.
    static std::vector<Window> parts(const Window& window) { return parts_of(window); }

    /// W13: the list of a part of a window: its own copy.
    template <class List>
    static std::shared_ptr<List> list_for_part(const std::shared_ptr<List>& list) {
        return std::make_shared<List>(*list);
    }

    /// PW1: what the corner depths start at.
    static auto first_corner_depth(const auto& kernel) { return kernel.farthest(); }

    /// PW3: does a polygon leave the list.
    static bool discards(bool surrounding, bool outside) { return !surrounding && outside; }

    /// PW7: is a polygon that is nearest at k corners a reason to doubt the surrounding one before it.
    static bool uncovers(int k) { return k > 0; }

    /// PL2: the corners of a window, gone round so that a positive cross product with a side lies outside.
    template <class K>
    static auto corners_around(const K& kernel, const Window& window) {
        return std::array{kernel.point(window.x, window.y), kernel.point(window.x, window.bottom()),
                          kernel.point(window.right(), window.bottom()), kernel.point(window.right(), window.y)};
    }

    /// PL5: do two cross products have strictly opposite signs.
    static bool opposite(const auto& kernel, const auto& p, const auto& q) {
        return kernel.sign(p) != Sign::zero && kernel.sign(p) == -kernel.sign(q);
    }

    /// I1: a vertex of the scene on the screen: y grows downward in both.
    static auto on_screen(const auto& kernel, const Area&, const glm::dvec3& vertex) { return kernel.vertex(vertex); }

    /// Z1: what Z starts at: every depth is nearer.
    static auto first_depth(const auto& kernel) { return kernel.farthest(); }

    /// L4: the columns first <= x < end that a line shows: those whose centres lie between its ends, these included.
    static std::pair<int, int> columns_shown(const auto& run, int row, const auto& left, const auto& right,
                                             const auto& /*polygon*/) {
        return {run.kernel.first_column(left, row, run.area.x, run.area.right()),
                run.kernel.last_column(right, row, run.area.x, run.area.right()) + 1};
    }

    /// FH1: what the horizons start at: there are none.
    template <class K>
    static Horizons<K> first_horizons(const K&, const Area& area) {
        return {{area, std::nullopt}, {area, std::nullopt}};
    }

    /// FH4: what a curve is compared with: the horizons as they are before it, whatever it raises. So a copy is kept.
    static const auto& horizons_before(const auto& horizons, auto& kept) { return kept.emplace(horizons); }

    /// FH5: which column of a segment is looked at after another.
    static int next_column(const Segment&, int column) { return column + 1; }

    /// FH6: is a step drawn that is on this side at both ends.
    static bool draws(VisibilityFlag side) { return side != VisibilityFlag::hidden; }

    /// FH8: by which horizon a segment becomes visible.
    static VisibilityFlag horizon_met(VisibilityFlag /*was*/, VisibilityFlag is) { return is; }

    /// SE1: is there no edge yet, for no curve has been there.
    static bool no_edge_yet(const std::optional<Sample>& edge) { return !edge; }

    /// SE2: over which columns an edge counts: at its ends there are the curves.
    static std::pair<int, int> edge_columns(const Segment& edge) {
        return {std::min(edge.from.x, edge.to.x) + 1, std::max(edge.from.x, edge.to.x) - 1};
    }

    /// V2: the flag of a point that is on both horizons.
    static VisibilityFlag flag_on_both() { return VisibilityFlag::both; }
};

}  // namespace vidno
