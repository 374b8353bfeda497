/// FloatingHorizonKernel: the arithmetic of the floating horizon: heights of segments over whole columns, and their
/// comparison.
///
/// OnColumns<K> adapts a kernel K. The general form computes each formula in K's own numbers; the one for `filtered` is
/// in kernels/filtered_heights.h.
#pragma once

#include <concepts>
#include <utility>

#include "../kernel.h"
#include "curves.h"

namespace vidno {

template <class K>
concept FloatingHorizonKernel = requires(const K& kernel, const Segment& segment, const typename K::Height& height) {
    // The column lies between the segment's ends, or is one of them. At an end the height is exactly the sample's.
    { kernel.height(segment, 0) } -> std::same_as<typename K::Height>;
    { kernel.point_on(segment, 0) } -> std::same_as<Point<typename K::Number>>;

    // Compares two heights over one column: positive if the first is above the second.
    { kernel.compare(height, height) } -> std::same_as<Sign>;

    // Where a segment crosses a horizon that has these heights over a column and the next; it is above one and below
    // the other.
    { kernel.crossing(segment, 0, height, height) } -> std::same_as<Point<typename K::Number>>;
};

/// Where the line from y1 to y2, over a column and the next, crosses that from h1 to h2.
template <class Number>
Point<Number> crossing_of(const Number& column, const Number& y1, const Number& y2, const Number& h1,
                          const Number& h2) {
    const Number before = y1 - h1;
    const Number after = y2 - h2;
    const Number t = before / (before - after);
    return {column + t, y1 + (y2 - y1) * t};
}

template <class K>
struct OnColumns : K {
    using Number = typename K::Number;
    using Height = Number;
    using K::number;

    OnColumns() = default;
    explicit OnColumns(K kernel) : K(std::move(kernel)) {}

    Height height(const Segment& segment, int column) const {
        const auto& [curve, from, to] = segment;
        if (column == from.x) return number(from.y);
        if (column == to.x) return number(to.y);
        const Number y1 = number(from.y);
        const Number slope = (number(to.y) - y1) / number(to.x - from.x);
        return slope * number(column - from.x) + y1;
    }

    Point<Number> point_on(const Segment& segment, int column) const {
        return {number(column), height(segment, column)};
    }

    Sign compare(const Height& a, const Height& b) const { return Sign{int(a < b) - int(b < a)}; }

    Point<Number> crossing(const Segment& segment, int column, const Height& h1, const Height& h2) const {
        return crossing_of<Number>(number(column), height(segment, column), height(segment, column + 1), h1, h2);
    }
};

}  // namespace vidno
