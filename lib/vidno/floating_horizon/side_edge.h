/// SideEdge: the horizons along the edge from the end of the curve before to that of the next, so that the side of the
/// surface hides what is behind it. The edge is not drawn, as in the text. Hidden parts of it raise nothing.
///
/// Takes   where the edge on this side has come to (nowhere yet, before the first curve), and the curve's end.
/// Gives   the horizons raised along the edge, and the edge at the curve's end.
#pragma once

#include "floating_horizon_run.h"

namespace vidno {

struct SideEdge {
    template <class Run>
    static void side_edge(Run& run, std::optional<Sample>& edge, int curve, const Sample& end) {
        using enum Line;
        if (!run.set.no_edge_yet(edge)) {  // SE1
            const Segment side{curve, *edge, end};
            const auto [first, last] = run.set.edge_columns(side);
            run.horizon(SE2, side, first, last);
        }
        edge = end;  // SE3
    }
};

}  // namespace vidno
