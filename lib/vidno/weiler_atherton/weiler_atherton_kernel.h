/// WeilerAthertonKernel: the arithmetic of Weiler and Atherton's algorithm: lines, their intersections, and depths
/// there.
///
/// OnRegions<K> adapts a kernel K and computes each formula in K's own numbers; the one for `filtered` is in
/// kernels/filtered_regions.h. A vertex is always constructed from two lines of the scene, never from constructed
/// vertices. So its coordinates do not grow longer in exact numbers, and do not drift in rounded ones.
#pragma once

#include <concepts>
#include <utility>

#include "region.h"

namespace vidno {

/// The formula by which two numbers are compared.
struct NumberDifference {
    template <class T>
    T operator()(const T& v, const T& w) const {
        return v - w;
    }
};

template <class K>
concept WeilerAthertonKernel = requires(const K& kernel, const typename K::Number& number,
                                        const Point<typename K::Number>& point,
                                        const LoopVertex<typename K::Number>& vertex,
                                        const SupportLine<typename K::Number>& line,
                                        const vidno::Plane<typename K::Number>& plane,
                                        const Region<typename K::Number>& region) {
    // From the scene and the screen.
    { kernel.vertex(glm::dvec3{}) } -> std::same_as<Vertex<typename K::Number>>;
    { kernel.place(0.0, 0.0) } -> std::same_as<Point<typename K::Number>>;

    { kernel.line_through(point, point) } -> std::same_as<SupportLine<typename K::Number>>;
    // The line where two planes that are not parallel meet; the first is nearer on its positive side. Its point is near
    // the scene.
    { kernel.parallel(plane, plane) } -> std::same_as<bool>;
    { kernel.line_of(plane, plane, point) } -> std::same_as<SupportLine<typename K::Number>>;

    // The side of a line on which a point lies, and whether it is left of an edge's line on its row.
    { kernel.side(line, point) } -> std::same_as<Sign>;
    { kernel.side(line, vertex) } -> std::same_as<Sign>;
    { kernel.left_of(point, line) } -> std::same_as<bool>;
    // The intersection of two lines that are not parallel.
    { kernel.meet(line, line) } -> std::same_as<Point<typename K::Number>>;
    { kernel.middle(point, point) } -> std::same_as<Point<typename K::Number>>;
    { kernel.mean(region) } -> std::same_as<Point<typename K::Number>>;  // of its vertices

    // The x of an edge's line on the row of a point, and the pixels next to it as in kernel.h.
    { kernel.on_row(line, point) } -> std::same_as<typename K::Number>;
    { kernel.first_centre(number, 0, 1) } -> std::same_as<int>;
    { kernel.last_centre(number, 0, 1) } -> std::same_as<int>;

    // The order of two points by x and then by y, and by y alone; whether two vertices are at one place.
    { kernel.order(point, point) } -> std::same_as<Sign>;
    { kernel.order_of_rows(point, point) } -> std::same_as<Sign>;
    { kernel.same_place(vertex, vertex) } -> std::same_as<bool>;
    // The sign of (a - pivot) x (b - pivot): pivot, a, b.
    { kernel.turn(point, point, point) } -> std::same_as<Sign>;

    // The order of two depths: positive if the first is nearer.
    { kernel.depth(plane, point) } -> std::same_as<typename K::Number>;
    { kernel.compare(number, number) } -> std::same_as<Sign>;
};

template <class K>
struct OnRegions : K {
    using Number = typename K::Number;
    using Place = Point<Number>;
    using Edge = SupportLine<Number>;
    using Planes = vidno::Plane<Number>;
    using K::number;

    OnRegions() = default;
    explicit OnRegions(K kernel) : K(std::move(kernel)) {}

    Vertex<Number> vertex(const glm::dvec3& v) const { return {number(v.x), number(v.y), number(v.z)}; }
    Place place(double x, double y) const { return {number(x), number(y)}; }

    /// At both points the formula of `side` gives 0 under any arithmetic.
    Edge line_through(const Place& p, const Place& q) const { return {p.y - q.y, q.x - p.x, p}; }

    bool parallel(const Planes& p, const Planes& q) const {
        const auto [a, b] = slope_over(p, q);
        return K::sign(a) == Sign::zero && K::sign(b) == Sign::zero;
    }
    bool parallel(const Edge& line, const Edge& other) const {
        return sign_of(cross, line.a, line.b, other.a, other.b) == Sign::zero;
    }
    /// Its point is the one nearest to `near`.
    Edge line_of(const Planes& p, const Planes& q, const Place& near) const {
        const auto [a, b] = slope_over(p, q);
        const Number t = (depth(p, near) - depth(q, near)) / (a * a + b * b);
        return {a, b, {near.x - a * t, near.y - b * t}};
    }

    Sign side(const Edge& line, const Place& p) const {
        return sign_of(height_over, line.a, line.b, line.on.x, line.on.y, p.x, p.y);
    }
    Sign side(const Edge& line, const LoopVertex<Number>& v) const {
        return v.on(line) ? Sign::zero : side(line, v.at);
    }
    bool left_of(const Place& p, const Edge& line) const {
        const Sign s = side(line, p);
        return s != Sign::zero && s == -K::sign(line.a);
    }

    Place meet(const Edge& line, const Edge& other) const {
        const Number height = height_over(other.a, other.b, other.on.x, other.on.y, line.on.x, line.on.y);
        const Number divisor = cross(line.a, line.b, other.a, other.b);
        return {line.on.x + line.b * height / divisor, line.on.y - line.a * height / divisor};
    }

    /// The x of a line on the row of a point; the line is not level.
    Number on_row(const Edge& line, const Place& p) const { return line.on.x - line.b * (p.y - line.on.y) / line.a; }

    Place middle(const Place& p, const Place& q) const {
        const Number two = number(2);
        return {(p.x + q.x) / two, (p.y + q.y) / two};
    }

    Place mean(const Region<Number>& region) const {
        Place sum = place(0, 0);
        int count = 0;
        for (const auto& loop : region.loops) {
            for (const auto& v : loop) {
                sum = {sum.x + v.at.x, sum.y + v.at.y};
                ++count;
            }
        }
        return {sum.x / number(count), sum.y / number(count)};
    }

    Sign order(const Place& p, const Place& q) const {
        const Sign by_x = compare(p.x, q.x);
        return by_x != Sign::zero ? by_x : compare(p.y, q.y);
    }
    Sign order_of_rows(const Place& p, const Place& q) const { return compare(p.y, q.y); }

    bool same_place(const LoopVertex<Number>& v, const LoopVertex<Number>& w) const {
        return meet_once(*this, v, w) || order(v.at, w.at) == Sign::zero;
    }

    Sign turn(const Place& pivot, const Place& p, const Place& q) const {
        return sign_of(cross_about, pivot.x, pivot.y, p.x, p.y, q.x, q.y);
    }

    Number depth(const Planes& plane, const Place& p) const {
        return -(plane.a * p.x + plane.b * p.y + plane.d) / plane.c;
    }
    Sign compare(const Number& v, const Number& w) const { return sign_of(NumberDifference{}, v, w); }

protected:
    /// Are both vertices the intersection of the same two lines, which meet only once?
    static bool meet_once(const auto& kernel, const LoopVertex<Number>& v, const LoopVertex<Number>& w) {
        return v.before != v.after && w.on(*v.before) && w.on(*v.after) && !kernel.parallel(*v.before, *v.after);
    }

private:
    /// The slope of one plane's depth relative to another's.
    static Place slope_over(const Planes& p, const Planes& q) { return {q.a / q.c - p.a / p.c, q.b / q.c - p.b / p.c}; }

    // Formulas are generic in the number type. So a kernel whose numbers have bounds can evaluate them with the bounds
    // first, in `sign_of`.

    static constexpr auto cross = []<class T>(const T& a, const T& b, const T& c, const T& d) -> T {
        return a * d - b * c;
    };
    static constexpr auto cross_about = []<class T>(const T& x, const T& y, const T& px, const T& py, const T& qx,
                                                    const T& qy) -> T {
        return (px - x) * (qy - y) - (py - y) * (qx - x);
    };
    static constexpr auto height_over = []<class T>(const T& a, const T& b, const T& on_x, const T& on_y, const T& x,
                                                    const T& y) -> T { return a * (x - on_x) + b * (y - on_y); };

    Sign sign_of(const auto& formula, const auto&... values) const {
        if constexpr (requires { K::sign_of(formula, values...); }) {
            return K::sign_of(formula, values...);
        } else {
            return K::sign(formula(values...));
        }
    }
};

}  // namespace vidno
