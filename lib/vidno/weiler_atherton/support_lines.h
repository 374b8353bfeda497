/// SupportLines: the lines whose intersections are the vertices of a run. Vertices point at them, so they stay where
/// they are.
///
/// There is one line for two points in either order, and one for the planes of two polygons. So neighbours share the
/// same line under any arithmetic.
#pragma once

#include <cassert>
#include <map>
#include <optional>
#include <utility>

#include "weiler_atherton_kernel.h"

namespace vidno {

/// The kernel must outlive this object.
template <WeilerAthertonKernel K>
class SupportLines {
public:
    using Number = typename K::Number;
    using Line = SupportLine<Number>;

    explicit SupportLines(const K& kernel) : kernel_(kernel) {}

    const Line* between(const Point<Number>& p, const Point<Number>& q) {
        const Ends ends = kernel_.order(p, q) == Sign::negative ? Ends(p, q) : Ends(q, p);
        const auto [known, is_new] = between_.try_emplace(ends);
        if (is_new) known->second = kernel_.line_through(ends.first, ends.second);
        return &known->second;
    }

    /// The line in which the planes of two polygons meet, seen from the viewer; none if they are parallel. On its
    /// positive side the one that comes later in the scene is the nearer.
    const Line* of_planes(const auto& later, const auto& earlier) {
        assert(later.index > earlier.index);
        const auto [known, is_new] = of_planes_.try_emplace({later.index, earlier.index});
        if (is_new && !kernel_.parallel(later.plane, earlier.plane)) {
            const auto& near = later.vertices.front();
            known->second = kernel_.line_of(later.plane, earlier.plane, {near.x, near.y});
        }
        return known->second ? &*known->second : nullptr;
    }

    /// The greatest number of parts into which these lines can divide the area.
    double most_parts() const {
        const auto lines = double(between_.size() + of_planes_.size());
        return 1 + lines * (lines + 1) / 2;
    }

private:
    using Ends = std::pair<Point<Number>, Point<Number>>;

    struct InOrder {
        const K& kernel;

        bool operator()(const Ends& a, const Ends& b) const {
            const Sign by_first = kernel.order(a.first, b.first);
            return by_first != Sign::zero ? by_first == Sign::negative
                                          : kernel.order(a.second, b.second) == Sign::negative;
        }
    };

    const K& kernel_;
    std::map<Ends, Line, InOrder> between_{InOrder{kernel_}};
    std::map<std::pair<int, int>, std::optional<Line>> of_planes_;
};

}  // namespace vidno
