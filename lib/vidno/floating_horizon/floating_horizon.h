/// FloatingHorizon: the visible parts of curves, from the nearest to the farthest: those beyond what the nearer curves
/// reach.
///
/// Source  H. Williamson, Algorithm 420: Hidden-line plotting program, CACM 15(2), 1972; T. J. Wright, A two-space
///         solution to the hidden line problem for plotting functions of two variables, IEEE Transactions on Computers
///         C-22(1), 1973; the course's form, which is that of D. F. Rogers, Procedural Elements for Computer Graphics,
///         1985.
/// Takes   a run with its curves.
/// Gives   the run's lines, in the order of the curves and from left to right, and its horizons.
/// Time    a few comparisons for each curve and column.
///
/// The rule. Over a column the upper horizon is the highest point, and the lower horizon the lowest, of the earlier
/// curves and of the side edges up to this curve's left one; an edge counts over the columns between its ends. Where
/// none of them reaches, there is no horizon. Between neighbouring columns that both have a horizon, it is the straight
/// line between them; elsewhere there is none. A point of a curve is visible if there is no horizon, or if it is not
/// strictly between the two: a point that touches one is visible. Lines include their ends, also where a horizon
/// begins.
///
/// Gaps. Where the surface has no point, its curve has a gap: FH4 to FH9 draw it piece by piece, and over the columns
/// of the gap it neither shows nor hides anything. The side edges lead to the outer ends of its pieces. They end before
/// a curve that has no piece, and begin anew after it.
///
/// Differences from the text, besides X-H1 and X-H2 (printed.h). The scan of the text ends in Visibility: we do not
/// know the rest of it, nor Horizon and Intersection, so the printed edition uses ours.
/// - X-H5. We examine a curve over every column, not only at its samples, since an obstacle between two samples hides
///   it too. The text advises more samples at sharp peaks.
/// - X-H4. We compare a curve with the horizons that the earlier curves left, and raise a second pair. The text has one
///   pair, so that a curve that dips under a horizon meets what it has just raised itself, up to a column too early.
///   Likewise an edge counts at its ends, where it meets the curve that it leads to.
/// - X-H6. A point may be on both horizons, where these meet. The text has one flag for it, and takes a continuation
///   below them for a crossing of both.
/// - X-H3. Initially there are no horizons. Those of the text begin at the sides of the screen: if two curves lie
///   beyond one, the farther may be hidden though nothing is in front of it.
#pragma once

#include "floating_horizon_run.h"

namespace vidno {

struct FloatingHorizon {
    template <class Run>
    static void floating_horizon(Run& run) {
        using enum Line;
        run.trace.horizons(FH1, run.horizons);
        std::optional<Sample> left_edge, right_edge;
        int curve = 0;
        for (const Curve& each : run.scene.curves) {
            run.trace.curve(FH2, curve);
            const auto pieces = pieces_of(each);  // one, unless the curve has gaps
            if (pieces.empty()) {
                left_edge = right_edge = std::nullopt;
            } else {
                run.side_edge(FH3, left_edge, curve, pieces.front().front());
                for (const Piece& samples : pieces) draw_curve(run, curve, samples);
                run.side_edge(FH10, right_edge, curve, pieces.back().back());
            }
            ++curve;
        }
    }

private:
    template <class Run>
    static void draw_curve(Run& run, int curve, const Piece& samples) {
        using enum Line;
        std::optional<Horizons<typename Run::Arithmetic>> kept;
        const auto& before = run.set.horizons_before(run.horizons, kept);
        auto flag = run.visibility(FH4, {curve, samples[0], samples[1]}, samples[0].x, before);  // Pflag
        for (std::size_t i = 1; i < samples.size(); ++i) {
            const Segment segment{curve, samples[i - 1], samples[i]};
            for (int x = segment.from.x; x < segment.to.x;) {
                const int next = run.set.next_column(segment, x);
                const auto next_flag = run.visibility(FH5, segment, next, before);  // Tflag
                draw_step(run, segment, {x, flag}, {next, next_flag}, before);
                x = next;  // FH9
                flag = next_flag;
            }
        }
    }

    /// A column that is examined.
    struct Step {
        int x;
        VisibilityFlag flag;
    };

    template <class Run>
    static void draw_step(Run& run, const Segment& segment, const Step& from, const Step& to, const auto& before) {
        using enum Line;
        using enum VisibilityFlag;
        const auto first = run.on_column(segment, from.x);
        const auto last = run.on_column(segment, to.x);
        const VisibilityFlag was = side_beside(from.flag, to.flag);
        const VisibilityFlag is = side_beside(to.flag, from.flag);
        if (was == is) {
            if (run.set.draws(is)) draw(run, FH6, segment, first, last);
            return;
        }
        if (was != hidden) {
            const auto end = run.intersection(FH7, segment, from.x, to.x, before.on(was), was);
            draw(run, FH7, segment, first, end);
        }
        if (is != hidden) {
            const VisibilityFlag met = run.set.horizon_met(was, is);
            const auto begin = run.intersection(FH8, segment, from.x, to.x, before.on(met), met);
            draw(run, FH8, segment, begin, last);
        }
    }

    static void draw(auto& run, Line at, const Segment& segment, const auto& from, const auto& to) {
        run.draw_line(at, segment, from, to);
        run.horizon(at, segment, from.right, to.left);
    }
};

}  // namespace vidno
