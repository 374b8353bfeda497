/// OctantAngles: the angle under which a window sees a polygon's outline, in octants: a full turn if the polygon
/// surrounds it.
///
/// The lines of its sides divide the plane around the window into eight octants, numbered clockwise on the screen:
///
///     0 | 1 | 2
///     --+---+--
///     7 |   | 3
///     --+---+--
///     6 | 5 | 4
///
/// A point on a line counts as beyond it. The angle of an edge is the difference of its ends' octants, the shorter way
/// round. For half of a full turn neither way is shorter: the edge then passes a corner of the window, and the line of
/// a side there splits it in two. The side of the corner on which the edge passes determines the octant in which the
/// parts meet.
///
/// Takes   a polygon, edge-on or not, and a window that none of its edges meets.
/// Gives   the sum: 8 or -8 octants if the polygon surrounds the window, 0 if it is outside.
/// Time    comparisons of coordinates; a cross product for each edge that is split.
#pragma once

#include "../run.h"

namespace vidno {

struct OctantAngles {
    /// Does an edge subtend a straight angle?
    static bool needs_split(int difference) { return difference == 4 || difference == -4; }

    template <class Run>
    static int octant_angles(Run& run, const Polygon<typename Run::Arithmetic>& polygon, const Window& window) {
        using enum Line;
        auto& trace = run.trace;
        const auto& vertices = polygon.vertices;
        const int count = int(vertices.size());
        const auto [upper_left, lower_left, upper_right, lower_right] = corners_of(run.kernel, window);
        const std::array corners{upper_left, upper_right, lower_right, lower_left};  // in the even octants

        int sum = 0;
        for (int i = 0; i < count; ++i) {
            const auto& from = vertices[i];
            const auto& to = vertices[(i + 1) % count];
            const int from_octant = octant_of(from, upper_left, lower_right);
            const int to_octant = octant_of(to, upper_left, lower_right);
            int difference = to_octant - from_octant;
            if (difference > 4) difference -= 8;
            if (difference < -4) difference += 8;
            const bool split = run.set.needs_split(difference);
            if (split) {
                const auto& corner = corners[(from_octant + 2) % 8 / 2];
                const auto value = run.kernel.cross(from, to, corner);
                const Sign sign = run.kernel.sign(value);
                trace.orient(OA4, polygon, i, corner, value, sign);
                difference = sign == Sign::negative ? -4 : 4;
            }
            trace.octants(split ? OA4 : OA3, polygon, i, from_octant, to_octant, difference);
            sum += difference;
        }
        return sum;
    }

private:
    static int octant_of(const auto& vertex, const auto& upper_left, const auto& lower_right) {
        constexpr int octants[3][3]{{0, 1, 2}, {7, 0, 3}, {6, 5, 4}};  // none is in the window
        const int column = vertex.x <= upper_left.x ? 0 : vertex.x >= lower_right.x ? 2 : 1;
        const int row = vertex.y <= upper_left.y ? 0 : vertex.y >= lower_right.y ? 2 : 1;
        return octants[row][column];
    }
};

}  // namespace vidno
