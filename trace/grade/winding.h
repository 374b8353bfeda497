/// Winding: exact areas of sets of loops. For the units that judge in exact numbers.
///
/// A layer is a set of loops. Its winding number at a point is the number of its loops that run clockwise on the screen
/// around the point, less those that run the other way. In a region, whose holes run the other way, it is 1 inside and
/// 0 outside.
#pragma once

#include <functional>
#include <vector>

#include "vidno/kernels/exact.h"

namespace vidno::grading {

struct Point2 {
    Rational x, y;
};

using Outline2 = std::vector<Point2>;
using Layer = std::vector<Outline2>;

/// Twice the area of (o, a, b), positive if it runs clockwise on the screen.
inline Rational cross(const Point2& o, const Point2& a, const Point2& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// The area where the winding numbers of the layers, in their order, are wanted. Where all are 0, they must not be
/// wanted.
double area_where(const std::vector<Layer>& layers, const std::function<bool(const std::vector<int>&)>& is_wanted);

}  // namespace vidno::grading
