/// SplitPiercing: cuts polygons that pierce each other along the line in which their planes meet.
///
/// Takes   the polygons of a scene, convex.
/// Gives   convex pieces: where two of them overlap, one is everywhere at least as near as the other.
/// Time    one clip for each pair of polygons whose boxes overlap and that the line in which their planes meet passes
///         through.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "weiler_atherton_run.h"

namespace vidno {

struct SplitPiercing {
    template <class Run>
    static std::vector<typename Run::Piece> split_piercing(Run& run, std::vector<typename Run::Piece> pieces) {
        using enum Line;
        for (std::size_t i = 1; i < pieces.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (run.apart(pieces[i], pieces[j])) continue;
                const auto* later = pieces[i].polygon;
                const auto* earlier = pieces[j].polygon;
                if (later->index < earlier->index) std::swap(later, earlier);
                const auto* line = run.lines.of_planes(*later, *earlier);
                const auto line_splits = [&](const auto& region) {
                    return !has_edge_on(region, *line) && is_on_both_sides(run.kernel, region, *line);
                };
                if (!line || !line_splits(pieces[i].region) || !line_splits(pieces[j].region)) continue;
                const auto common = run.region_clip(SP1, pieces[i], pieces[j]).inside;
                if (!is_on_both_sides(run.kernel, common, *line)) continue;
                run.trace.pierce(SP2, *later, *earlier, *line);
                for (const std::size_t k : {i, j}) {
                    auto [one, other] = split(run, pieces[k].region, *line);
                    if (one.empty() || other.empty()) continue;  // by rounding: the line leaves no area on a side
                    run.trace.split(SP3, *pieces[k].polygon, one, other);
                    const auto* polygon = pieces[k].polygon;
                    pieces[k] = {polygon, std::move(one)};
                    pieces.emplace_back(polygon, std::move(other));
                }
            }
        }
        return pieces;
    }

private:
    /// A convex region with an edge on a line is on one side of it, however its vertices were rounded.
    static bool has_edge_on(const auto& region, const auto& line) {
        const auto& outline = region.loops.front();
        return std::any_of(outline.begin(), outline.end(), [&](const auto& vertex) { return vertex.after == &line; });
    }

    static bool is_on_both_sides(const auto& kernel, const auto& region, const auto& line) {
        bool positive = false, negative = false;
        for (const auto& loop : region.loops) {
            for (const auto& vertex : loop) {
                const Sign side = kernel.side(line, vertex);
                positive = positive || side == Sign::positive;
                negative = negative || side == Sign::negative;
            }
        }
        return positive && negative;
    }

    /// The parts of a convex region on the two sides of a line.
    template <class Run>
    static auto split(Run& run, const Region<typename Run::Number>& region, const auto& line) {
        using enum Line;
        auto vertices = region.loops.front();
        const int count = int(vertices.size());
        struct Sided {
            EdgePiece<typename Run::Number> piece;
            bool positive;
        };
        std::vector<Sided> round;
        for (int from = 0; from < count; ++from) {
            const int to = (from + 1) % count;
            const auto* edge = vertices[from].after;
            const Sign from_side = run.kernel.side(line, vertices[from]);
            const Sign to_side = run.kernel.side(line, vertices[to]);
            if (from_side != Sign::zero && from_side == -to_side) {
                const int crossing = int(vertices.size());
                vertices.push_back({run.kernel.meet(*edge, line), edge, &line});
                round.push_back({{from, crossing, edge}, from_side == Sign::positive});
                round.push_back({{crossing, to, edge}, to_side == Sign::positive});
            } else {
                const Sign side = from_side != Sign::zero ? from_side : to_side;
                round.push_back({{from, to, edge}, side == Sign::positive});
            }
        }

        // Each part runs along the line from the beginning of the other part to its end.
        typename Run::Pieces positive, negative;
        bool before = round.back().positive;
        int enters = 0, leaves = 0;
        for (const auto& [piece, is_positive] : round) {
            if (is_positive != before) (is_positive ? enters : leaves) = piece.from;
            (is_positive ? positive : negative).push_back(piece);
            before = is_positive;
        }
        positive.push_back({leaves, enters, &line});
        negative.push_back({enters, leaves, &line});
        return std::pair(run.joined(SP3, vertices, positive), run.joined(SP3, vertices, negative));
    }
};

}  // namespace vidno
