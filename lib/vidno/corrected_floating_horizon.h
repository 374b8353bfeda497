/// CorrectedFloatingHorizon: the floating horizon with the errors of the printed text corrected. The default set for
/// curves; corrected.h explains sets.
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
    /// FH1: the initial horizons: none.
    template <class K>
    static Horizons<K> first_horizons(const K&, const Area& area) {
        return {{area, std::nullopt}, {area, std::nullopt}};
    }

    /// FH4: the horizons that a curve is compared with: a copy made before the curve, so that it never meets what it
    /// raised itself.
    static const auto& horizons_before(const auto& horizons, auto& kept) { return kept.emplace(horizons); }

    /// FH5: the column of a segment that is examined after another.
    static int next_column(const Segment&, int column) { return column + 1; }

    /// FH6: is a step drawn that is on this side at both ends?
    static bool draws(VisibilityFlag side) { return side != VisibilityFlag::hidden; }

    /// FH8: the horizon at which a segment becomes visible.
    static VisibilityFlag horizon_met(VisibilityFlag /*was*/, VisibilityFlag is) { return is; }

    /// SE1: is there no side edge yet, because this is the first curve?
    static bool no_edge_yet(const std::optional<Sample>& edge) { return !edge; }

    /// SE2: the columns over which an edge counts: those strictly between its ends. At its ends the curves count.
    static std::pair<int, int> edge_columns(const Segment& edge) {
        return {std::min(edge.from.x, edge.to.x) + 1, std::max(edge.from.x, edge.to.x) - 1};
    }

    /// V2: the flag of a point on both horizons.
    static VisibilityFlag flag_on_both() { return VisibilityFlag::both; }
};

}  // namespace vidno
