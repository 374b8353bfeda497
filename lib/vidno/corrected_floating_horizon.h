/// CorrectedFloatingHorizon: the floating horizon with the errors of the printed text put right. The default set for curves; corrected.h
/// says what a set is.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "floating_horizon/floating_horizon.h"
#include "floating_horizon/horizon.h"
#include "floating_horizon/intersection.h"
#include "floating_horizon/side_edge.h"
#include "floating_horizon/visibility.h"

namespace vidno {

struct CorrectedFloatingHorizon : FloatingHorizon, SideEdge, Visibility, Horizon, Intersection {
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
