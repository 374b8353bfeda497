/// RegionClip: the part of one region inside another, and the part outside.
///
/// Source  K. Weiler, P. Atherton, Hidden surface removal using polygon area sorting, SIGGRAPH 1977. The paper walks
///         along the subject's outline, turns into the clip polygon's at a leaving vertex, and turns back at an
///         entering vertex. Here each piece of an edge is classified separately, so that touches and shared edges need
///         no rules.
/// Takes   the subject and the clip region; either may have holes.
/// Gives   both parts: they share only outlines, and together are the subject.
/// Time    a few signs for each pair of edges.
#pragma once

#include "loops.h"
#include "weiler_atherton_run.h"

namespace vidno {

struct RegionClip {
    template <class Run>
    static ClippedRegion<typename Run::Number> region_clip(Run& run, const Region<typename Run::Number>& subject,
                                                           const Region<typename Run::Number>& clip) {
        using enum Line;
        const Overlay overlay(run.kernel, subject, clip);  // RC1
        typename Run::Pieces inside, outside;
        for (const auto& loop : overlay.subject) {
            auto before = loop.back().lies;
            for (const auto& piece : loop) {
                const auto& [from, to, line, lies] = piece;
                run.trace.edge_piece(RC2, overlay.vertices[from].at, overlay.vertices[to].at, lies);
                if (goes_inside(lies) && !goes_inside(before)) run.trace.enter(RC3, overlay.vertices[from].at);
                if (!goes_inside(lies) && goes_inside(before)) run.trace.leave(RC3, overlay.vertices[from].at);
                (goes_inside(lies) ? inside : outside).push_back(piece);  // RC4, RC5
                before = lies;
            }
        }
        for (const auto& loop : overlay.clip) {
            for (const auto& piece : loop) {
                if (piece.lies != Lies::inside) continue;
                inside.push_back(piece);              // RC4
                outside.push_back(piece.reversed());  // RC5
            }
        }
        return {run.joined(RC4, overlay.vertices, inside), run.joined(RC5, overlay.vertices, outside)};
    }

private:
    /// Does a piece of the subject's outline bound the part inside, or the part outside?
    static bool goes_inside(Lies lies) { return lies == Lies::inside || lies == Lies::same_side; }
};

}  // namespace vidno
