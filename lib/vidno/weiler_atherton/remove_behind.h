/// RemoveBehind: the pieces that the clip polygon does not hide.
///
/// Takes   pieces that lie inside the clip polygon, and have one depth order with it everywhere (SplitPiercing); and it.
/// Gives   those that are nearer than it, in their order. Among equal depths the first polygon of the scene is the nearer.
/// Time    a comparison for each piece. Two planes' difference in depth at the mean of the vertices is the mean of those at
///         the vertices, which are of one sign: it is 0 only if the planes are one.
#pragma once

#include "weiler_atherton_run.h"

namespace vidno {

struct RemoveBehind {
    template <class Run>
    static std::vector<typename Run::Piece> remove_behind(Run& run, const std::vector<typename Run::Piece>& inside,
                                                          const typename Run::Piece& clip) {
        using enum Line;
        std::vector<typename Run::Piece> nearer;
        for (const auto& piece : inside) {  // RB1
            if (piece.is_ground) continue;
            const auto place = run.kernel.mean(piece.region);
            const auto z = run.depth(RB2, *piece.polygon, place);
            const auto clip_z = run.depth(RB2, *clip.polygon, place);
            const Sign order = run.kernel.compare(z, clip_z);
            const bool is_nearer =
                order == Sign::positive || (order == Sign::zero && piece.polygon->index < clip.polygon->index);
            run.trace.behind(RB3, *piece.polygon, *clip.polygon, place, z, clip_z, order, !is_nearer);
            if (is_nearer) nearer.push_back(piece);
        }
        return nearer;  // RB4
    }
};

}  // namespace vidno
