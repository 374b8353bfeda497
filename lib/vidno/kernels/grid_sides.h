/// GridSides: on which side of a line the vertices of a clipped polygon lie, for the kernel `grid`. The decisions are
/// right, since all numbers behind them are on the grid.
#pragma once

#include "number_kernel.h"

namespace vidno {

/// A vertex of a clipped polygon: one of its vertices, where an edge meets a side of the window, or the window's
/// corner. At least one of x and y is exact then, and the edge gives the other until the vertex is found to lie on a
/// side.
struct GridVertex {
    mutable double x, y;
    double z;
    mutable bool x_is_exact, y_is_exact;
    const Vertex<double>* from;  // the edge that it is on, or that begins there
    const Vertex<double>* to;

    /// Makes the vertex exact, once it is found to lie on a side. Two edges may end there. The segment between their
    /// ends is then part of the side, and of no edge.
    void put_on(bool vertical, double at) const {
        (vertical ? x : y) = at;
        (vertical ? x_is_exact : y_is_exact) = true;
    }
};

struct GridSides {
    /// (a - pivot) x (b - pivot) for the line along a side of a window: as computed, and its true sign.
    struct SideCross {
        double value;
        Sign sign;
        bool vertical;
        double at;  // the x of a vertical side, the y of a level one

        explicit operator double() const { return value; }
    };

    /// The computed x, at a given y, of the line through two vertices with different y.
    static double x_at(const auto& from, const auto& to, double y) {
        return from.x + (y - from.y) * (to.x - from.x) / (to.y - from.y);
    }

    /// The sign of X - x, where X is the line's x at y; x and y are on the grid.
    static Sign sign_of_line(const auto& from, const auto& to, double x, double y) {
        const Sign turn = sign_of_cross(from, to, Point<double>{x, y});
        return from.y < to.y ? turn : -turn;
    }

    static Sign sign_right_of(const GridVertex& v, double x) {
        return v.x_is_exact ? machine.sign(v.x - x) : sign_of_line(*v.from, *v.to, x, v.y);
    }
    static Sign sign_below(const GridVertex& v, double y) {
        if (v.y_is_exact) return machine.sign(v.y - y);
        const Sign turn = sign_of_cross(*v.from, *v.to, Point<double>{v.x, y});
        return v.from->x < v.to->x ? -turn : turn;
    }
    static Sign sign_below(const Vertex<double>& v, double y) { return machine.sign(v.y - y); }

    // A vertex that was not clipped is exact; the edge to the next vertex begins there.
    static bool x_is_exact(const GridVertex& v) { return v.x_is_exact; }
    static bool x_is_exact(const Vertex<double>&) { return true; }
    static const Vertex<double>& from_of(const GridVertex& p, const GridVertex&) { return *p.from; }
    static const Vertex<double>& to_of(const GridVertex& p, const GridVertex&) { return *p.to; }
    static const Vertex<double>& from_of(const Vertex<double>& p, const Vertex<double>&) { return p; }
    static const Vertex<double>& to_of(const Vertex<double>&, const Vertex<double>& q) { return q; }

    // If neither of two neighbours has an exact x (or y), both lie on p's edge, which is then not vertical (or not
    // level).
    static bool on_upright_line(const GridVertex& p, const GridVertex& q) {
        return (q.x_is_exact && sign_right_of(p, q.x) == Sign::zero) ||
               (p.x_is_exact && sign_right_of(q, p.x) == Sign::zero);
    }
    static bool on_level_line(const GridVertex& p, const GridVertex& q) {
        return (q.y_is_exact && sign_below(p, q.y) == Sign::zero) || (p.y_is_exact && sign_below(q, p.y) == Sign::zero);
    }
    static bool on_upright_line(const Vertex<double>& p, const Vertex<double>& q) { return p.x == q.x; }
    static double x_of_line(const GridVertex& p, const GridVertex& q) { return p.x_is_exact ? p.x : q.x; }
    static double x_of_line(const Vertex<double>& p, const Vertex<double>&) { return p.x; }

private:
    static Sign sign_of_cross(const auto& from, const auto& to, const Point<double>& p) {
        return machine.sign(machine.cross(from, to, p));
    }

    static constexpr NumberKernel<double> machine{};
};

}  // namespace vidno
