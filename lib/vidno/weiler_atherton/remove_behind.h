/// RemoveBehind: the pieces that the clip polygon does not hide.
///
/// Takes   the clip polygon, and pieces that lie inside it and have the same depth order with it everywhere
///         (SplitPiercing).
/// Gives   the pieces that are nearer than it, in their order. At equal depths the first polygon of the scene is
///         nearer.
/// Time    one comparison for each piece. The difference of two planes' depths at the mean of the vertices is the mean
///         of the differences at the vertices. These have the same sign, so it is 0 only if the planes are the same.
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
