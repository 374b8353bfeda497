/// PrintedFloatingHorizon: the floating horizon as the course text prints it. Each difference has its id, as in
/// printed.h.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "corrected_floating_horizon.h"

namespace vidno {

struct PrintedFloatingHorizon : CorrectedFloatingHorizon {
    /// X-H3: the horizons begin at the sides of the screen, in the text 0 and its height, where y grows upward. Beyond
    /// a side the higher of two curves may be hidden.
    template <class K>
    static Horizons<K> first_horizons(const K& kernel, const Area& area) {
        return {{area, kernel.number(area.bottom())}, {area, kernel.number(area.y)}};
    }

    /// X-H4: a curve is compared with the horizons that it has raised itself, and meets its own side edge.
    static const auto& horizons_before(const auto& horizons, auto& /*kept*/) { return horizons; }
    static std::pair<int, int> edge_columns(const Segment& edge) { return std::minmax({edge.from.x, edge.to.x}); }

    /// X-H5: an obstacle between two samples is not seen.
    static int next_column(const Segment& segment, int) { return segment.to.x; }

    /// X-H6: a point on both horizons has the flag of one.
    static VisibilityFlag flag_on_both() { return VisibilityFlag::above; }

    /// X-H1: the minus is lost in the test for -1, and in the edges' start value -1.
    static bool draws(VisibilityFlag side) { return side == VisibilityFlag::above; }
    static bool no_edge_yet(const std::optional<Sample>& edge) { return !edge || edge->x == 1; }

    /// X-H2: a curve that emerges below is cut by the upper horizon.
    static VisibilityFlag horizon_met(VisibilityFlag was, VisibilityFlag is) {
        return was == VisibilityFlag::hidden ? VisibilityFlag::above : is;
    }
};

}  // namespace vidno
