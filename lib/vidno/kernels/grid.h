/// Grid: decisions that are always right for a scene whose coordinates lie on a grid, without exact arithmetic, as in
/// graphics hardware.
///
/// x and y are whole multiples of 2^-K pixel, z of 2^-24 (snap.h makes such a scene). So the coordinates are whole
/// numbers, small enough that a double holds their cross products exactly, and 128 bits the comparison of two depths.
/// Doubles decide the comparisons that need a division (an edge on a row, a depth) where the bound on their error
/// allows it, otherwise the whole numbers decide.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "grid_plane.h"
#include "grid_sides.h"
#include "number_kernel.h"
#include "plane_depths.h"

namespace vidno {

class Grid : public PlaneDepths<GridPlane, NoTally>, private GridSides {
public:
    using Coordinate = double;
    using Number = double;
    using Plane = GridPlane;
    using Outline = std::vector<GridVertex>;
    using Vertices = std::vector<Vertex<double>>;

    static constexpr std::string_view name = "grid";

    /// 1 <= bits <= finest_grid: steps of 2^-bits.
    explicit Grid(int bits) { frame_.steps = std::ldexp(1, bits); }

    /// The scene is one that snap.h made for this grid.
    void see(const Scene& scene) {
        frame_.x = scene.area.x;
        frame_.y = scene.area.y;
        farthest_ = farthest_out(scene);
        // The error of an edge's x: one roundoff for each row stepped, of numbers no larger than this.
        column_error_ = (scene.area.height + 8) * farthest_ * 0x1p-50;
        expect_planes(scene.polygons.size());
    }

    Vertex<double> vertex(const glm::dvec3& v) const { return machine_.vertex(v); }
    Point<double> point(double x, double y) const { return {x, y}; }
    double centre(int pixel) const { return pixel + 0.5; }

    Sign sign(double cross) const { return machine_.sign(cross); }
    double cross(const auto& pivot, const auto& a, const auto& b) const { return machine_.cross(pivot, a, b); }

    Plane plane(const vidno::Plane<double>& computed, const Vertices& vertices) {
        return keep(grid_plane(computed, vertices, frame_, farthest_), vertices);
    }

    bool outside(const Box<double>& box, const Window& window) const { return machine_.outside(box, window); }
    bool inside(const Box<double>& box, const Window& window) const { return machine_.inside(box, window); }

    int first_centre(double value, int low, int end) const { return machine_.first_centre(value, low, end); }
    int last_centre(double value, int low, int end) const { return machine_.last_centre(value, low, end); }

    // ------------------------------------------------------------------------------------- clipping

    Outline outline(const Vertices& vertices) const {
        Outline outline;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto& v = vertices[i];
            outline.push_back({v.x, v.y, v.z, true, true, &v, &vertices[(i + 1) % vertices.size()]});
        }
        return outline;
    }

    Sign sign(const SideCross& cross) const { return cross.sign; }

    SideCross cross(const Point<double>& pivot, const GridVertex& a, const Point<double>& b) const {
        const bool vertical = pivot.x == b.x;
        const double at = vertical ? pivot.x : pivot.y;
        const Sign beyond = vertical ? sign_right_of(a, at) : sign_below(a, at);
        const bool same_way = vertical ? b.y > pivot.y : b.x < pivot.x;
        const SideCross cross{machine_.cross(pivot, a, b), same_way ? beyond : -beyond, vertical, at};
        if (beyond == Sign::zero) a.put_on(vertical, at);
        return cross;
    }

    /// Two neighbours with the same x or y are on an earlier side, or on a vertical or level edge. Otherwise both are
    /// on p's edge.
    GridVertex meet(const GridVertex& p, const GridVertex& q, const SideCross& cp, const SideCross& cq) const {
        const double z = p.z + (q.z - p.z) * (cp.value / (cp.value - cq.value));
        const auto& from = *p.from;
        const auto& to = *p.to;
        if (cp.vertical) {
            if (on_level_line(p, q)) return {cp.at, p.y_is_exact ? p.y : q.y, z, true, true, p.from, p.to};
            return {cp.at, from.y + (cp.at - from.x) * (to.y - from.y) / (to.x - from.x), z, true, false, p.from, p.to};
        }
        if (on_upright_line(p, q)) return {x_of_line(p, q), cp.at, z, true, true, p.from, p.to};
        return {x_at(from, to, cp.at), cp.at, z, false, true, p.from, p.to};
    }

    // ------------------------------------------------------------------------------------- filling

    Rows rows_of(const auto& outline, int low, int end) const {
        Rows rows{end, low};
        for (const auto& v : outline) {
            rows.first = std::min(rows.first, first_row(v, low, end));
            rows.end = std::max(rows.end, last_row(v, low, end) + 1);
        }
        return rows;
    }

    Columns<double> columns_of(const auto& outline, int row, int low, int end) const {
        const double y = centre(row);
        Columns<double> found{1, 0, end, low};
        const auto include = [&](double x, int first, int last) {
            const bool is_first = found.left > found.right;
            found.left = is_first ? x : std::min(found.left, x);
            found.right = is_first ? x : std::max(found.right, x);
            found.first = std::min(found.first, first);
            found.end = std::max(found.end, last + 1);
        };
        const auto include_edge = [&](const auto& from, const auto& to) {
            const double x = x_at(from, to, y);
            include(x, first_column(from, to, x, row, low, end), last_column(from, to, x, row, low, end));
        };
        const auto include_place = [&](double x) { include(x, first_centre(x, low, end), last_centre(x, low, end)); };

        const auto* p = &outline.back();
        Sign p_side = sign_below(*p, y);
        for (const auto& q : outline) {
            const Sign q_side = sign_below(q, y);
            if (q_side == Sign::zero && x_is_exact(q)) include_place(q.x);
            if (q_side == Sign::zero && !x_is_exact(q)) include_edge(from_of(q, q), to_of(q, q));
            if (p_side != Sign::zero && q_side == -p_side) {
                if (on_upright_line(*p, q)) {
                    include_place(x_of_line(*p, q));
                } else {
                    include_edge(from_of(*p, q), to_of(*p, q));
                }
            }
            p = &q;
            p_side = q_side;
        }
        if (found.left > found.right) found.first = found.end = low;
        return found;
    }

    // ------------------------------------------------------------------------------------- active edges

    int first_column(const auto& end_point, int row, int low, int end) const {
        if constexpr (requires { end_point.upper; }) {
            return first_column(end_point.upper, end_point.lower, end_point.x, row, low, end);
        } else {
            return first_centre(end_point.x, low, end);
        }
    }
    int last_column(const auto& end_point, int row, int low, int end) const {
        if constexpr (requires { end_point.upper; }) {
            return last_column(end_point.upper, end_point.lower, end_point.x, row, low, end);
        } else {
            return last_centre(end_point.x, low, end);
        }
    }
    bool same_place(const auto& a, const auto& b, int row) const {
        if constexpr (requires { a.upper; }) {
            return !surely_apart(a.x, b.x) && compared_at(a, b, row) == Sign::zero;
        } else {
            return a.x == b.x;
        }
    }
    bool left_of(const auto& a, const auto& b, int row) const {
        if (surely_apart(a.x, b.x)) return a.x < b.x;
        const Sign sign = compared_at(a, b, row);
        return sign == Sign::zero ? less_slope(a, b) : sign == Sign::negative;
    }

private:
    // The answer of the double is off by at most one; the edge decides.
    int first_row(const auto& v, int low, int end) const {
        int row = first_centre(v.y, low, end);
        while (row > low && sign_below(v, centre(row - 1)) != Sign::positive) --row;
        while (row < end && sign_below(v, centre(row)) == Sign::positive) ++row;
        return row;
    }
    int last_row(const auto& v, int low, int end) const {
        int row = last_centre(v.y, low, end);
        while (row < end - 1 && sign_below(v, centre(row + 1)) != Sign::negative) ++row;
        while (row >= low && sign_below(v, centre(row)) == Sign::negative) --row;
        return row;
    }

    /// How many centres of low <= i < end lie left of x, if its error leaves no doubt, so that none is at x; otherwise
    /// -1.
    int surely_left(double x, int low, int end) const {
        const double pixels = x - (low + 0.5);
        if (pixels < -column_error_) return 0;
        if (pixels > end - low) return end - low;
        const int whole = int(pixels);
        const double part = pixels - whole;
        return part > column_error_ && part < 1 - column_error_ ? whole + 1 : -1;
    }

    int first_column(const auto& from, const auto& to, double x, int row, int low, int end) const {
        const int left = surely_left(x, low, end);
        return left >= 0 ? low + left : exactly_first_column(from, to, x, row, low, end);
    }
    int last_column(const auto& from, const auto& to, double x, int row, int low, int end) const {
        const int left = surely_left(x, low, end);
        return left >= 0 ? low + left - 1 : exactly_last_column(from, to, x, row, low, end);
    }
    [[gnu::noinline]] int exactly_first_column(const auto& from, const auto& to, double x, int row, int low,
                                               int end) const {
        const auto is_left = [&](int i) { return sign_of_line(from, to, centre(i), centre(row)) == Sign::positive; };
        int column = first_centre(x, low, end);
        while (column > low && !is_left(column - 1)) --column;
        while (column < end && is_left(column)) ++column;
        return column;
    }
    [[gnu::noinline]] int exactly_last_column(const auto& from, const auto& to, double x, int row, int low,
                                              int end) const {
        const auto is_right = [&](int i) { return sign_of_line(from, to, centre(i), centre(row)) == Sign::negative; };
        int column = last_centre(x, low, end);
        while (column < end - 1 && !is_right(column + 1)) ++column;
        while (column >= low && is_right(column)) --column;
        return column;
    }

    bool surely_apart(double ax, double bx) const { return std::abs(ax - bx) > 2 * column_error_; }

    /// The sign of A - B, where A and B are the x of the two edges on the row.
    [[gnu::noinline]] Sign compared_at(const auto& a, const auto& b, int row) const {
        const auto times_height = [&](const auto& edge, std::int64_t height) {
            const auto [upper, lower] = std::pair(edge.upper, edge.lower);
            const std::int64_t along =
                (frame_.row(centre(row)) - frame_.row(upper.y)) * (frame_.column(lower.x) - frame_.column(upper.x));
            return (Int128(frame_.column(upper.x)) * height_of(edge) + along) * height;
        };
        const Int128 ax = times_height(a, height_of(b));
        const Int128 bx = times_height(b, height_of(a));
        return Sign{int(ax > bx) - int(ax < bx)};
    }
    std::int64_t height_of(const auto& edge) const { return frame_.row(edge.lower.y) - frame_.row(edge.upper.y); }

    static bool less_slope(const auto& a, const auto& b) {
        return (a.lower.x - a.upper.x) * (b.lower.y - b.upper.y) < (b.lower.x - b.upper.x) * (a.lower.y - a.upper.y);
    }

    static constexpr NumberKernel<double> machine_{};

    GridFrame frame_;
    double farthest_ = 0;
    double column_error_ = 0;
};

}  // namespace vidno
