/// Kernel: the only place where arithmetic is chosen.
///
/// A procedure sees values that compare and the operations below; what a comparison costs and whether it is
/// certain is the kernel's affair. kernels/ holds the kernels; machine.h is the simplest to read.
#pragma once

#include <concepts>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "window.h"

namespace vidno {

enum class Sign { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign sign) { return Sign{-int(sign)}; }

/// A place on the screen: a window's corner or a pixel's centre.
template <class Number>
struct Point {
    Number x, y;
};

template <class Number>
struct Vertex {
    Number x, y, z;
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

template <class Number>
struct Crossings {
    Number left, right;
};

template <class K>
concept Kernel = requires(const K& kernel, const typename K::Number& number, const typename K::Depth& depth,
                          const Point<typename K::Number>& point, const Vertex<typename K::Number>& vertex,
                          const Plane<typename K::Number>& plane, const Box<typename K::Number>& box,
                          const Window& window) {
    { K::name } -> std::convertible_to<std::string_view>;

    // From the scene and the screen.
    { kernel.vertex(glm::dvec3{}) } -> std::same_as<Vertex<typename K::Number>>;
    { kernel.point(0.0, 0.0) } -> std::same_as<Point<typename K::Number>>;
    { kernel.centre(0) } -> std::same_as<typename K::Number>;  // i + 1/2

    // The sign of a value, and (a - pivot) x (b - pivot): x and y alone count.
    { kernel.sign(number) } -> std::same_as<Sign>;
    { kernel.cross(vertex, vertex, point) } -> std::same_as<typename K::Number>;

    // Where the segment from p to q, whose ends have the cross products cp and cq of opposite sign, meets the line.
    { kernel.meet(vertex, vertex, number, number) } -> std::same_as<Vertex<typename K::Number>>;

    // Depth, and "no polygon yet", which every depth is nearer than.
    { kernel.depth(plane, point) } -> std::same_as<typename K::Depth>;
    { kernel.farthest() } -> std::same_as<typename K::Depth>;
    { kernel.finite(depth) } -> std::same_as<typename K::Number>;  // of a plane's depth
    { kernel.nearer(depth, depth) } -> std::same_as<bool>;

    // A polygon's box against a window: apart, and strictly inside.
    { kernel.outside(box, window) } -> std::same_as<bool>;
    { kernel.inside(box, window) } -> std::same_as<bool>;

    // The first pixel of low <= i < end whose centre is at or after the value (end if there is none), the last
    // whose centre is at or before it (low - 1 if there is none). A NaN gives low and low - 1: nothing.
    { kernel.first_centre(number, 0, 1) } -> std::same_as<int>;
    { kernel.last_centre(number, 0, 1) } -> std::same_as<int>;

    // The least and the greatest x where a convex outline meets the line of that y (left > right if nowhere).
    { kernel.crossings(std::vector{vertex}, number) } -> std::same_as<Crossings<typename K::Number>>;

    // a / b; where the numbers have no infinity, b = 0 throws DivisionByZero.
    { kernel.divide(number, number) } -> std::same_as<typename K::Number>;
};

/// Thrown by kernels without infinities; the corrected procedures never divide by zero there.
struct DivisionByZero {};

}  // namespace vidno
