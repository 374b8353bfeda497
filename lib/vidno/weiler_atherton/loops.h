/// Loops: joins the pieces of edges that bound a region.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "overlay.h"

namespace vidno {

/// Each piece has its region on its positive side. Where several pieces begin at one vertex, a loop takes the sharpest
/// turn to that side. So it follows one corner of the region, and parts that only touch there get separate loops. Two
/// pieces of one edge are joined where no other begins. Rounding may lose a piece. A loop that then does not close is
/// omitted, and `lost()` is called.
template <WeilerAthertonKernel K, class Number = typename K::Number>
Region<Number> joined(const K& kernel, const std::vector<LoopVertex<Number>>& vertices,
                      const std::vector<EdgePiece<Number>>& pieces, auto&& lost) {
    std::vector<std::vector<int>> beginning(vertices.size());  // at each vertex, the pieces that are in no loop yet
    for (std::size_t i = 0; i < pieces.size(); ++i) beginning[pieces[i].from].push_back(int(i));
    std::vector<bool> several_begin;
    for (const auto& at_vertex : beginning) several_begin.push_back(at_vertex.size() > 1);

    // Pieces of one line do not turn, however their ends were rounded.
    const auto turn = [&](const auto& arriving, const auto& next) {
        if (next.line == arriving.line) return Sign::zero;
        return kernel.turn(vertices[arriving.to].at, vertices[arriving.from].at, vertices[next.to].at);
    };
    const auto is_sharper = [&](const auto& arriving, const auto& a, const auto& b) {
        const Sign turn_a = turn(arriving, a);
        const Sign turn_b = turn(arriving, b);
        if (turn_a != turn_b) return turn_a < turn_b;
        return kernel.turn(vertices[arriving.to].at, vertices[a.to].at, vertices[b.to].at) == Sign::negative;
    };

    Region<Number> region;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const int first = int(i);
        const auto& unused = beginning[pieces[i].from];
        if (std::find(unused.begin(), unused.end(), first) == unused.end()) continue;
        std::vector<int> way;
        int next = first;
        do {
            way.push_back(next);
            const auto& arriving = pieces[next];
            auto& choice = beginning[arriving.to];
            const auto sharpest = std::min_element(
                choice.begin(), choice.end(), [&](int a, int b) { return is_sharper(arriving, pieces[a], pieces[b]); });
            if (sharpest == choice.end()) break;
            next = *sharpest;
            choice.erase(sharpest);
        } while (next != first);
        if (next != first) {
            std::erase(beginning[pieces[i].from], first);
            lost();
            continue;
        }
        Loop<Number> loop;
        const auto* before = pieces[way.back()].line;
        for (const int piece : way) {
            const auto& [from, to, line, lies] = pieces[piece];
            if (before != line || several_begin[from]) loop.push_back({vertices[from].at, before, line});
            before = line;
        }
        if (loop.size() >= 3) region.loops.push_back(std::move(loop));
    }
    return region;
}

}  // namespace vidno
