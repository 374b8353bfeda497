/// GridPlane: a polygon's plane for the kernel `grid`, in whole numbers.
///
/// Numbers  The scene is W < 2^24 grid steps across. A cross product is at most 2 W^2 < 2^49. A depth is N / c with
///          |c| <= 2 W^2, twice the polygon's area, and |N| <= W^2 (2^25 + 2^27), so |N c'| < 2^125.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "number_kernel.h"
#include "plane_depths.h"

namespace vidno {

__extension__ using Int128 = __int128;

inline constexpr int finest_grid = 20;        // the greatest K
inline constexpr int grid_depth_bits = 24;    // z is a multiple of 2^-24
inline constexpr double grid_width = 0x1p24;  // a scene has fewer steps across

/// The origin of a scene's coordinates, and the steps of its grid.
struct GridFrame {
    double x = 0, y = 0;
    double steps = 1;  // in a pixel

    std::int64_t column(double at) const { return std::int64_t((at - x) * steps); }
    std::int64_t row(double at) const { return std::int64_t((at - y) * steps); }
};

/// A polygon's plane, z = (x_factor column + y_factor row + rest) / (divisor 2^24).
struct GridPlane : ApproximatePlane {
    double a = 0, b = 0, c = 0, d = 0;                     // as the text has it
    std::int64_t x_factor = 0, y_factor = 0, divisor = 0;  // divisor > 0
    Int128 rest = 0;
    GridFrame frame;

    bool exactly_nearer(const GridPlane& than, double x, double y) const {
        return scaled_depth(x, y) * than.divisor > than.scaled_depth(x, y) * divisor;
    }

private:
    Int128 scaled_depth(double x, double y) const {
        return Int128(x_factor) * frame.column(x) + Int128(y_factor) * frame.row(y) + rest;
    }
};

/// A vertex as seen from another, in steps of the grid.
struct GridCorner {
    std::int64_t x, y, z;

    GridCorner(const Vertex<double>& v, const Vertex<double>& from, const GridFrame& frame)
        : x(in_steps(v.x - from.x, frame.steps)),
          y(in_steps(v.y - from.y, frame.steps)),
          z(in_steps(v.z - from.z, std::ldexp(1, grid_depth_bits))) {}

private:
    static std::int64_t in_steps(double difference, double in_one) { return std::int64_t(difference * in_one); }
};

/// The plane of a polygon that was computed from its vertices v, none of which is farther out than `farthest`.
inline GridPlane grid_plane(const Plane<double>& computed, const std::vector<Vertex<double>>& v, const GridFrame& frame,
                            double farthest) {
    GridPlane plane;
    plane.a = computed.a;
    plane.b = computed.b;
    plane.c = computed.c;
    plane.d = computed.d;
    // The text's plane, Newell's sum about the first vertex, in whole numbers.
    for (std::size_t i = 2; i < v.size(); ++i) {
        const GridCorner p(v[i - 1], v[0], frame);
        const GridCorner q(v[i], v[0], frame);
        plane.divisor += p.x * q.y - p.y * q.x;
        plane.x_factor += p.z * q.y - p.y * q.z;
        plane.y_factor += p.x * q.z - p.z * q.x;
    }
    const int way_round = plane.divisor < 0 ? -1 : 1;
    plane.divisor *= way_round;
    plane.x_factor *= way_round;
    plane.y_factor *= way_round;
    plane.frame = frame;
    const auto z = std::int64_t(std::ldexp(v[0].z, grid_depth_bits));
    plane.rest = Int128(plane.divisor) * z - Int128(plane.x_factor) * frame.column(v[0].x) -
                 Int128(plane.y_factor) * frame.row(v[0].y);

    const double scale = std::ldexp(frame.steps, -grid_depth_bits) / double(plane.divisor);
    plane.x_slope = double(plane.x_factor) * scale;
    plane.y_slope = double(plane.y_factor) * scale;
    plane.at_origin = v[0].z - plane.x_slope * v[0].x - plane.y_slope * v[0].y;
    // About sixteen roundoffs of the sum of the terms.
    plane.error = (1 + (std::abs(plane.x_slope) + std::abs(plane.y_slope)) * farthest) * 0x1p-48;
    return plane;
}

}  // namespace vidno
