/// Region: a part of the plane, bounded by loops of straight edges. It need not be convex, and may have holes.
///
/// Every edge has the region on its positive side: for v inside, (q - p) x (v - p) > 0 near the edge from p to q. So
/// outlines and holes have opposite orientations. Loops of one region may touch each other at vertices, and nowhere
/// else.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "../kernel.h"

namespace vidno {

/// a (x - on.x) + b (y - on.y) = 0: an edge of the scene, a side of the area, or where two planes meet.
template <class Number>
struct SupportLine {
    Number a, b;
    Point<Number> on;
};

/// The point where two edges meet. It stores their lines, so no computation is needed to know that it lies on them.
template <class Number>
struct LoopVertex {
    Point<Number> at;
    const SupportLine<Number>* before;  // of the edge that ends here
    const SupportLine<Number>* after;   // of the edge that begins here

    bool on(const SupportLine<Number>& line) const { return before == &line || after == &line; }
};

template <class Number>
using Loop = std::vector<LoopVertex<Number>>;

template <class Number>
struct Region {
    std::vector<Loop<Number>> loops;

    bool empty() const { return loops.empty(); }
};

/// visit(from, to) for each edge of a loop: its line is from.after.
void for_each_edge(const auto& loop, auto&& visit) {
    const auto* from = &loop.back();
    for (const auto& to : loop) {
        visit(*from, to);
        from = &to;
    }
}

/// The least box around a region that is not empty.
template <class Number>
Box<Number> box_around(const Region<Number>& region) {
    const auto& first = region.loops.front().front();
    Box<Number> box{first.at.x, first.at.y, first.at.x, first.at.y};
    for (const auto& loop : region.loops) {
        for (const auto& vertex : loop) {
            const auto& at = vertex.at;
            if (select_lesser(at.x, box.xmin)) box.xmin = at.x;
            if (select_lesser(at.y, box.ymin)) box.ymin = at.y;
            if (select_lesser(box.xmax, at.x)) box.xmax = at.x;
            if (select_lesser(box.ymax, at.y)) box.ymax = at.y;
        }
    }
    return box;
}

/// Where a piece of an edge lies in relation to the other region; on its outline, whether both regions are on the same
/// side of it.
enum class Lies : unsigned char { inside, outside, same_side, other_side };
inline constexpr std::array<std::string_view, 4> lies_names{"inside", "outside", "same_side", "other_side"};

/// A piece of an edge, between two vertices of an Overlay.
template <class Number>
struct EdgePiece {
    int from, to;
    const SupportLine<Number>* line;
    Lies lies = Lies::outside;

    EdgePiece reversed() const { return {to, from, line, lies}; }
};

/// The result of RegionClip.
template <class Number>
struct ClippedRegion {
    Region<Number> inside, outside;
};

}  // namespace vidno
