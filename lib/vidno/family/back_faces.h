/// BackFaces: the faces of a closed body that look away from the viewer and so cannot be seen.
///
/// Source  L. G. Roberts, Machine perception of three-dimensional solids, 1963.
#pragma once

#include "../run.h"

namespace vidno {

struct BackFaces {
    /// Takes   a convex polygon that is not edge-on, counter-clockwise as seen from outside the body.
    /// Gives   whether it looks away: the viewer then sees its vertices in clockwise order, and c > 0, since y grows
    ///         downward. The sign of c is that of the first turn that is not 0.
    /// Time    a cross product a vertex, up to that turn.
    template <class Run>
    static bool looks_away(Run& run, const Polygon<typename Run::Arithmetic>& polygon) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;
        const int count = int(vertices.size());
        Sign turn = Sign::zero;
        for (int i = 0; i < count && turn == Sign::zero; ++i) {
            const auto& next = vertices[(i + 2) % count];
            const auto value = run.kernel.cross(vertices[i], vertices[(i + 1) % count], next);
            turn = run.kernel.sign(value);
            trace.orient(BF1, polygon, i, next, value, turn);
        }
        const bool away = turn == Sign::positive;
        trace.back_face(BF2, polygon, away);
        return away;
    }
};

}  // namespace vidno
