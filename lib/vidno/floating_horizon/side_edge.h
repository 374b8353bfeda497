/// SideEdge: raises the horizons along the edge from the end of one curve to that of the next, so that the side of the
/// surface hides what is behind it. As in the text, the edge is not drawn. Its hidden parts raise nothing.
///
/// Takes   the point that the edge on this side has reached (none before the first curve), and the curve's end.
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
