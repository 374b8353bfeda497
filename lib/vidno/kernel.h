/// Kernel: the only place where arithmetic is chosen.
///
/// A procedure sees only values that compare, and the operations below. The kernel determines what a comparison costs
/// and whether it is certain. kernels/ holds the kernels; machine.h is the simplest to read.
#pragma once

#include <concepts>
#include <cstddef>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "window.h"

namespace vidno {

enum class Sign { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign sign) { return Sign{-int(sign)}; }

/// The index of a sign in a table for negative, zero, positive.
constexpr std::size_t place_of(Sign sign) { return sign == Sign::negative ? 0 : sign == Sign::zero ? 1 : 2; }

/// A place on the screen: a window's corner or a pixel's centre.
template <class Number>
struct Point {
    Number x, y;
};

/// A place on the screen: a pixel's centre.
struct Pixel {
    int x, y;
};

/// x and y may have another type than z: coordinates of the scene are given, a depth may be computed.
template <class Number, class Depth = Number>
struct Vertex {
    Number x, y;
    Depth z;
};

/// a x + b y + c z + d = 0.
template <class Number>
struct Plane {
    Number a, b, c, d;
};

/// The least box with sides along the axes, both ends included.
template <class Number>
struct Box {
    Number xmin, ymin, xmax, ymax;
};

/// Whether to select a as the lesser of two numbers. If they are equal, either will do: a judge does not list that as a
/// coincidence.
template <class Number>
bool select_lesser(const Number& a, const Number& b) {
    return a < b;
}

/// The rows first <= row < end.
struct Rows {
    int first, end;
};

/// Where an outline meets a row (left > right if nowhere), and the pixels first <= x < end with their centres there.
template <class Number>
struct Columns {
    Number left, right;
    int first, end;
};

template <class K>
concept Kernel = requires(K& own, const K& kernel, const Scene& scene, const typename K::Coordinate& coordinate,
                          const typename K::Number& number, const typename K::Interpolated& interpolated,
                          const typename K::Depth& depth, const Point<typename K::Coordinate>& point,
                          const Vertex<typename K::Coordinate>& vertex,
                          const std::vector<Vertex<typename K::Coordinate>>& vertices,
                          const Plane<typename K::Number>& computed, const typename K::Plane& plane,
                          const typename K::Outline& outline, typename K::DepthBuffer& depths,
                          const Box<typename K::Coordinate>& box, const Window& window) {
    { K::name } -> std::convertible_to<std::string_view>;

    // Called before anything else.
    own.see(scene);

    // From the scene and the screen. What is computed from coordinates is a number; both compare.
    { kernel.vertex(glm::dvec3{}) } -> std::same_as<Vertex<typename K::Coordinate>>;
    { kernel.point(0.0, 0.0) } -> std::same_as<Point<typename K::Coordinate>>;
    { kernel.centre(0) } -> std::same_as<typename K::Coordinate>;  // i + 1/2
    { (coordinate - coordinate) * number / number + number } -> std::convertible_to<typename K::Number>;

    // (a - pivot) x (b - pivot), x and y alone count; and its sign.
    { kernel.sign(kernel.cross(vertex, vertex, point)) } -> std::same_as<Sign>;

    // Called for every polygon, before any depth.
    { own.plane(computed, vertices) } -> std::same_as<typename K::Plane>;

    // The depth of a plane, and "no polygon yet", which is farther than every depth. Two depths are compared at one
    // common point.
    { kernel.depth(plane, point) } -> std::same_as<typename K::Depth>;
    { kernel.finite(depth) } -> std::same_as<typename K::Interpolated>;  // of a plane's depth
    { kernel.farthest() } -> std::same_as<typename K::Depth>;
    { kernel.nearer(depth, depth, point) } -> std::same_as<bool>;

    // A depth interpolated between vertices: nothing; a plane's at a pixel, stepped along the row; and as a cell of the
    // Z-buffer holds it, which is compared.
    { kernel.zero() } -> std::same_as<typename K::Interpolated>;
    requires requires(decltype(kernel.to_step(interpolated, plane, Pixel{})) stepped) {
        { kernel.nearer(kernel.to_store(stepped), depths.row(0)[0], Pixel{}) } -> std::same_as<bool>;
        depths.row(0)[0] = kernel.to_store(stepped);
        stepped += interpolated;
    };

    // Whether a polygon's box lies apart from a window, and whether it lies strictly inside.
    { kernel.outside(box, window) } -> std::same_as<bool>;
    { kernel.inside(box, window) } -> std::same_as<bool>;

    // A polygon while it is clipped. kernel.meet(p, q, cp, cq) is the point where the segment from p to q meets a side
    // of the window; cp and cq, of opposite sign, are the cross products of its ends with that side.
    { kernel.outline(vertices) } -> std::same_as<typename K::Outline>;
    kernel.cross(point, outline.front(), point);

    // The first pixel of low <= i < end whose centre is at or after the value (end if there is none), and the last
    // whose centre is at or before it (low - 1 if there is none). A NaN gives low and low - 1: an empty range.
    { kernel.first_centre(coordinate, 0, 1) } -> std::same_as<int>;
    { kernel.last_centre(coordinate, 0, 1) } -> std::same_as<int>;

    // The rows low <= row < end whose centres lie between the ends of a convex outline, and the outline's columns on a
    // row.
    { kernel.rows_of(outline, 0, 1) } -> std::same_as<Rows>;
    { kernel.columns_of(outline, 0, 0, 1).first } -> std::convertible_to<int>;
    { kernel.columns_of(vertices, 0, 0, 1).first } -> std::convertible_to<int>;

    // On a row: first_centre and last_centre for the end of a span; whether two ends are at one place; and the order of
    // two active edges, by x and then by dx. An end of a span is an active edge or a vertex.
    { kernel.first_column(vertex, 0, 0, 1) } -> std::same_as<int>;
    { kernel.last_column(vertex, 0, 0, 1) } -> std::same_as<int>;
    { kernel.same_place(vertex, vertex, 0) } -> std::same_as<bool>;
};

/// A kernel that runs the printed text: one whose decisions may be wrong, or the reference.
template <class K>
concept PrintedKernel = Kernel<K> && requires(const K& kernel, const typename K::Number& number) {
    kernel.depth_of(number);
    kernel.divide(number, number);
    kernel.same_rounded(number, number);
    kernel.pixel_of(number);
};

/// Thrown by kernels without infinities; the corrected procedures never divide by zero there.
struct DivisionByZero {};

}  // namespace vidno
