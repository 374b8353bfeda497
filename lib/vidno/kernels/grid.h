/// Grid: decisions that are always right for a scene whose coordinates lie on a grid, without exact arithmetic, as in graphics
/// hardware.
///
/// x and y are whole multiples of 2^-K pixel, z of 2^-24 (snap.h makes such a scene). So the coordinates are whole numbers, small
/// enough that a double holds their cross products exactly, and 128 bits the comparison of two depths. Doubles decide the
/// comparisons that need a division (an edge on a row, a depth) where the bound on their error allows it, otherwise the whole
/// numbers decide.
///
/// Numbers  The scene is W < 2^24 grid steps across. A cross product is at most 2 W^2 < 2^49. A depth is N / c with
///          |c| <= 2 W^2, twice the polygon's area, and |N| <= W^2 (2^25 + 2^27), so |N c'| < 2^125.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <string_view>
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

/// A vertex of a clipped polygon: one of its vertices, where an edge meets a side of the window, or the window's corner.
/// At least one of x and y is exact then, and the edge gives the other.
struct GridVertex {
    double x, y, z;
    bool x_is_exact, y_is_exact;
    const Vertex<double>* from;  // the edge that it is on, or that begins there
    const Vertex<double>* to;
};

class Grid : public PlaneDepths<GridPlane, NoTally> {
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

    Plane plane(const vidno::Plane<double>& computed, const Vertices& v) {
        Plane plane;
        plane.a = computed.a;
        plane.b = computed.b;
        plane.c = computed.c;
        plane.d = computed.d;
        // The text's plane, Newell's sum about the first vertex, in whole numbers.
        for (std::size_t i = 2; i < v.size(); ++i) {
            const Corner p = corner(v[i - 1], v[0]);
            const Corner q = corner(v[i], v[0]);
            plane.divisor += p.x * q.y - p.y * q.x;
            plane.x_factor += p.z * q.y - p.y * q.z;
            plane.y_factor += p.x * q.z - p.z * q.x;
        }
        const int way_round = plane.divisor < 0 ? -1 : 1;
        plane.divisor *= way_round;
        plane.x_factor *= way_round;
        plane.y_factor *= way_round;
        plane.frame = frame_;
        const auto z = std::int64_t(std::ldexp(v[0].z, grid_depth_bits));
        plane.rest = Int128(plane.divisor) * z - Int128(plane.x_factor) * frame_.column(v[0].x) -
                     Int128(plane.y_factor) * frame_.row(v[0].y);

        const double scale = std::ldexp(frame_.steps, -grid_depth_bits) / double(plane.divisor);
        plane.x_slope = double(plane.x_factor) * scale;
        plane.y_slope = double(plane.y_factor) * scale;
        plane.at_origin = v[0].z - plane.x_slope * v[0].x - plane.y_slope * v[0].y;
        // About sixteen roundoffs of the sum of the terms.
        plane.error = (1 + (std::abs(plane.x_slope) + std::abs(plane.y_slope)) * farthest_) * 0x1p-48;
        return keep(plane, v);
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

    /// (a - pivot) x (b - pivot) for the line along a side of a window: as computed, and its true sign.
    struct SideCross {
        double value;
        Sign sign;
        bool vertical;
        double at;  // the x of a vertical side, the y of a level one

        explicit operator double() const { return value; }
    };
    Sign sign(const SideCross& cross) const { return cross.sign; }

    SideCross cross(const Point<double>& pivot, const GridVertex& a, const Point<double>& b) const {
        const bool vertical = pivot.x == b.x;
        const double at = vertical ? pivot.x : pivot.y;
        const Sign beyond = vertical ? sign_right_of(a, at) : sign_below(a, at);
        const bool same_way = vertical ? b.y > pivot.y : b.x < pivot.x;
        return {machine_.cross(pivot, a, b), same_way ? beyond : -beyond, vertical, at};
    }

    /// Two neighbours with the same x or y are on an earlier side, or on a vertical or level edge. Otherwise both are on p's edge.
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
    struct Corner {
        std::int64_t x, y, z;
    };
    Corner corner(const Vertex<double>& v, const Vertex<double>& from) const {
        const auto steps = [](double difference, double in_one) { return std::int64_t(difference * in_one); };
        return {steps(v.x - from.x, frame_.steps), steps(v.y - from.y, frame_.steps),
                steps(v.z - from.z, std::ldexp(1, grid_depth_bits))};
    }

    /// The computed x, at a given y, of the line through two vertices with different y.
    static double x_at(const auto& from, const auto& to, double y) {
        return from.x + (y - from.y) * (to.x - from.x) / (to.y - from.y);
    }

    /// The sign of X - x, where X is the line's x at y; x and y are on the grid.
    Sign sign_of_line(const auto& from, const auto& to, double x, double y) const {
        const Sign turn = sign(cross(from, to, Point<double>{x, y}));
        return from.y < to.y ? turn : -turn;
    }

    Sign sign_right_of(const GridVertex& v, double x) const {
        return v.x_is_exact ? sign(v.x - x) : sign_of_line(*v.from, *v.to, x, v.y);
    }
    Sign sign_below(const GridVertex& v, double y) const {
        if (v.y_is_exact) return sign(v.y - y);
        const Sign turn = sign(cross(*v.from, *v.to, Point<double>{v.x, y}));
        return v.from->x < v.to->x ? -turn : turn;
    }
    Sign sign_below(const Vertex<double>& v, double y) const { return sign(v.y - y); }

    // A vertex that was not clipped is exact; the edge to the next vertex begins there.
    static bool x_is_exact(const GridVertex& v) { return v.x_is_exact; }
    static bool x_is_exact(const Vertex<double>&) { return true; }
    static const Vertex<double>& from_of(const GridVertex& p, const GridVertex&) { return *p.from; }
    static const Vertex<double>& to_of(const GridVertex& p, const GridVertex&) { return *p.to; }
    static const Vertex<double>& from_of(const Vertex<double>& p, const Vertex<double>&) { return p; }
    static const Vertex<double>& to_of(const Vertex<double>&, const Vertex<double>& q) { return q; }

    // If neither of two neighbours has an exact x (or y), both lie on p's edge, which is then not vertical (or not level).
    bool on_upright_line(const GridVertex& p, const GridVertex& q) const {
        return (q.x_is_exact && sign_right_of(p, q.x) == Sign::zero) ||
               (p.x_is_exact && sign_right_of(q, p.x) == Sign::zero);
    }
    bool on_level_line(const GridVertex& p, const GridVertex& q) const {
        return (q.y_is_exact && sign_below(p, q.y) == Sign::zero) || (p.y_is_exact && sign_below(q, p.y) == Sign::zero);
    }
    static bool on_upright_line(const Vertex<double>& p, const Vertex<double>& q) { return p.x == q.x; }
    static double x_of_line(const GridVertex& p, const GridVertex& q) { return p.x_is_exact ? p.x : q.x; }
    static double x_of_line(const Vertex<double>& p, const Vertex<double>&) { return p.x; }

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

    /// How many centres of low <= i < end lie left of x, if its error leaves no doubt, so that none is at x; otherwise -1.
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
