/// The procedure set of recorded and judged runs over curves. It selects the edition at run time, as run_time_set.h
/// does for polygons.
#pragma once

#include "choice/edition.h"
#include "vidno/printed_floating_horizon.h"

namespace vidno {

struct AnyFloatingHorizon : CorrectedFloatingHorizon {
    Edition edition;

    explicit AnyFloatingHorizon(Edition text) : edition(text) {}

    bool has(Deviation deviation) const { return edition.has(deviation); }

    template <class K>
    Horizons<K> first_horizons(const K& kernel, const Area& area) const {
        return has(Deviation::x_h3) ? PrintedFloatingHorizon::first_horizons(kernel, area)
                                    : CorrectedFloatingHorizon::first_horizons(kernel, area);
    }
    const auto& horizons_before(const auto& horizons, auto& kept) const {
        return has(Deviation::x_h4) ? PrintedFloatingHorizon::horizons_before(horizons, kept)
                                    : CorrectedFloatingHorizon::horizons_before(horizons, kept);
    }
    std::pair<int, int> edge_columns(const Segment& edge) const {
        return has(Deviation::x_h4) ? PrintedFloatingHorizon::edge_columns(edge)
                                    : CorrectedFloatingHorizon::edge_columns(edge);
    }
    int next_column(const Segment& segment, int column) const {
        return has(Deviation::x_h5) ? PrintedFloatingHorizon::next_column(segment, column)
                                    : CorrectedFloatingHorizon::next_column(segment, column);
    }
    VisibilityFlag flag_on_both() const {
        return has(Deviation::x_h6) ? PrintedFloatingHorizon::flag_on_both() : CorrectedFloatingHorizon::flag_on_both();
    }
    bool draws(VisibilityFlag side) const {
        return has(Deviation::x_h1) ? PrintedFloatingHorizon::draws(side) : CorrectedFloatingHorizon::draws(side);
    }
    bool no_edge_yet(const std::optional<Sample>& edge) const {
        return has(Deviation::x_h1) ? PrintedFloatingHorizon::no_edge_yet(edge)
                                    : CorrectedFloatingHorizon::no_edge_yet(edge);
    }
    VisibilityFlag horizon_met(VisibilityFlag was, VisibilityFlag is) const {
        return has(Deviation::x_h2) ? PrintedFloatingHorizon::horizon_met(was, is)
                                    : CorrectedFloatingHorizon::horizon_met(was, is);
    }
};

}  // namespace vidno
