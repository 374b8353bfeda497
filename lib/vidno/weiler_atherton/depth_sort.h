/// DepthSort: sorts the pieces by their greatest depth, the nearest first.
///
/// Takes   pieces in the order of the scene.
/// Gives   them sorted; pieces of equal greatest depth keep their order. The order is a guess at what is in front:
///         where it is wrong, the algorithm detects it and clips again.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "../insertion_sort.h"
#include "weiler_atherton_run.h"

namespace vidno {

struct DepthSort {
    template <class Run>
    static std::vector<typename Run::Piece> depth_sort(Run& run, const std::vector<typename Run::Piece>& pieces) {
        using enum Line;
        struct Entry {
            typename Run::Number greatest_z;
            std::size_t place;
        };
        std::vector<Entry> entries;
        for (const auto& piece : pieces) {
            entries.push_back({greatest_depth(run, piece), entries.size()});
            run.trace.greatest_depth(DS1, *piece.polygon, entries.back().greatest_z);
        }
        insertion_sort(entries, [&](const Entry& a, const Entry& b) {
            return run.kernel.compare(a.greatest_z, b.greatest_z) == Sign::positive;
        });
        std::vector<typename Run::Piece> sorted;
        for (const auto& entry : entries) sorted.push_back(pieces[entry.place]);
        return sorted;  // DS2
    }

private:
    static auto greatest_depth(auto& run, const auto& piece) {
        using enum Line;
        const auto& outline = piece.region.loops.front();
        auto greatest = run.depth(DS1, *piece.polygon, outline.front().at);
        for (std::size_t i = 1; i < outline.size(); ++i) {
            const auto z = run.depth(DS1, *piece.polygon, outline[i].at);
            if (run.kernel.compare(z, greatest) == Sign::positive) greatest = z;
        }
        return greatest;
    }
};

}  // namespace vidno
