/// ApproximatePlane: the depths of a plane as doubles, with a bound on their error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "../scene.h"
#include "../window.h"

namespace vidno {

/// z = x_slope x + y_slope y + at_origin, wrong by at most the error at any point of the scene.
struct ApproximatePlane {
    double x_slope = 0, y_slope = 0, at_origin = 0;
    double error = 0;
    bool fits_cells = false;   // at its polygon's vertices
    std::uint32_t number = 0;  // 0: no plane, infinitely far

    double depth(double x, double y) const { return x_slope * x + (y_slope * y + at_origin); }
};

/// The greatest |x| or |y| of a scene's vertices and windows.
inline double farthest_out(const Scene& scene) {
    const Window square = covering_square(scene.area);
    double farthest =
        std::max({std::abs(square.x), std::abs(square.y), std::abs(square.right()), std::abs(square.bottom())});
    for (const auto& polygon : scene.polygons) {
        for (const auto& v : polygon.vertices) farthest = std::max({farthest, std::abs(v.x), std::abs(v.y)});
    }
    return farthest;
}

}  // namespace vidno
