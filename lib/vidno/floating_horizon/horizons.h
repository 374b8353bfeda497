/// Horizons: the highest and the lowest points of the curves so far, over each column of the area.
#pragma once

#include <cassert>
#include <optional>
#include <vector>

#include "floating_horizon_kernel.h"

namespace vidno {

/// How a point lies in relation to the horizons: it is visible unless hidden. The values are the text's; `both` is
/// where the two meet.
enum class VisibilityFlag : signed char { below = -1, hidden = 0, above = 1, both = 2 };

/// The side on which a point counts as visible, or hidden. A point on both takes the side of its neighbour if that is
/// visible.
constexpr VisibilityFlag side_beside(VisibilityFlag flag, VisibilityFlag neighbour) {
    using enum VisibilityFlag;
    if (flag != both) return flag;
    return neighbour == below ? below : above;
}

/// One of the two horizons: a height over each column, or none where nothing has raised it yet.
template <FloatingHorizonKernel K>
class HorizonArray {
public:
    using Cell = std::optional<typename K::Height>;

    HorizonArray(const Area& area, const Cell& start) : first_(area.x), cells_(std::size_t(area.width), start) {}

    Cell& operator[](int column) { return cells_[index(column)]; }
    const Cell& operator[](int column) const { return cells_[index(column)]; }
    const Cell& leftmost() const { return cells_.front(); }

private:
    std::size_t index(int column) const {
        assert(first_ <= column && column - first_ < int(cells_.size()));
        return std::size_t(column - first_);
    }

    int first_;
    std::vector<Cell> cells_;
};

template <FloatingHorizonKernel K>
struct Horizons {
    HorizonArray<K> upper, lower;

    /// The horizon that a point must pass to be visible on this side.
    const HorizonArray<K>& on(VisibilityFlag side) const { return side == VisibilityFlag::above ? upper : lower; }
};

/// Is a height on the horizon or beyond it, on that side? True where there is no horizon.
template <FloatingHorizonKernel K>
bool reaches_horizon(const K& kernel, const typename K::Height& y, const typename HorizonArray<K>::Cell& horizon,
                     VisibilityFlag side) {
    return !horizon || kernel.compare(y, *horizon) != Sign{-int(side)};
}

}  // namespace vidno
