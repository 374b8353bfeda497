/// The procedure set of recorded and judged runs over curves: the edition is chosen at run time (recorded_set.h does so for polygons).
#pragma once

#include "run/rules.h"
#include "vidno/printed_curves.h"

namespace vidno {

struct AnyCurveEdition : CorrectedCurves {
    Rules rules;

    explicit AnyCurveEdition(Rules by) : rules(by) {}

    bool has(Rule rule) const { return rules.has(rule); }

    template <class K>
    Horizons<K> first_horizons(const K& kernel, const Area& area) const {
        return has(Rule::x_h3) ? PrintedCurves::first_horizons(kernel, area)
                               : CorrectedCurves::first_horizons(kernel, area);
    }
    const auto& horizons_before(const auto& horizons, auto& kept) const {
        return has(Rule::x_h4) ? PrintedCurves::horizons_before(horizons, kept)
                               : CorrectedCurves::horizons_before(horizons, kept);
    }
    std::pair<int, int> edge_columns(const Segment& edge) const {
        return has(Rule::x_h4) ? PrintedCurves::edge_columns(edge) : CorrectedCurves::edge_columns(edge);
    }
    int next_column(const Segment& segment, int column) const {
        return has(Rule::x_h5) ? PrintedCurves::next_column(segment, column)
                               : CorrectedCurves::next_column(segment, column);
    }
    VisibilityFlag flag_on_both() const {
        return has(Rule::x_h6) ? PrintedCurves::flag_on_both() : CorrectedCurves::flag_on_both();
    }
    bool draws(VisibilityFlag side) const {
        return has(Rule::x_h1) ? PrintedCurves::draws(side) : CorrectedCurves::draws(side);
    }
    bool no_edge_yet(const std::optional<Sample>& edge) const {
        return has(Rule::x_h1) ? PrintedCurves::no_edge_yet(edge) : CorrectedCurves::no_edge_yet(edge);
    }
    VisibilityFlag horizon_met(VisibilityFlag was, VisibilityFlag is) const {
        return has(Rule::x_h2) ? PrintedCurves::horizon_met(was, is) : CorrectedCurves::horizon_met(was, is);
    }
};

}  // namespace vidno
