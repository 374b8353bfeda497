/// NumberKernel: a kernel that computes each formula as the text has it, in a given number type.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "../depth_buffer.h"
#include "../kernel.h"

namespace vidno {

/// How a coordinate of the scene or the screen becomes a number: as C++ converts it.
template <class T>
struct Converted {
    T number(double given) const { return T(given); }
};

/// The greatest whole number low <= i < end that is not above the value, which lies in that range.
template <class T>
int whole_part(const T& value, int low, int end) {
    if constexpr (std::numeric_limits<T>::has_infinity) {
        const auto given = double(value);
        const int towards_zero = int(given);
        return towards_zero > given ? towards_zero - 1 : towards_zero;
    } else {
        while (low + 1 < end) {
            const int middle = std::midpoint(low, end);
            (T(middle) <= value ? low : end) = middle;
        }
        return low;
    }
}

/// `Entry` converts coordinates to numbers. A kernel whose numbers hold more than their value has its own.
template <class T, class Entry = Converted<T>>
struct NumberKernel : Entry {
    using Entry::number;
    using Number = T;
    using Coordinate = T;
    using Interpolated = T;
    using Plane = vidno::Plane<T>;
    using Outline = std::vector<Vertex<T>>;

    static constexpr bool has_infinity = std::numeric_limits<T>::has_infinity;
    /// Whether the centre of every pixel that a scene may have is held without rounding.
    static constexpr bool holds_centres = std::is_same_v<T, double>;

    /// Where the numbers have no infinity, "no polygon yet" is the empty depth: it compares below every other.
    using Depth = std::conditional_t<has_infinity, T, std::optional<T>>;

    using DepthBuffer = vidno::DepthBuffer<Depth>;

    NumberKernel() = default;
    explicit NumberKernel(Entry entry) : Entry(std::move(entry)) {}

    void see(const Scene&) {}

    Vertex<T> vertex(const glm::dvec3& v) const { return {number(v.x), number(v.y), number(v.z)}; }
    Point<T> point(double x, double y) const { return {number(x), number(y)}; }
    T centre(int pixel) const { return number(pixel + 0.5); }

    Sign sign(const T& value) const { return Sign{int(value > 0) - int(value < 0)}; }

    T cross(const auto& pivot, const auto& a, const auto& b) const {
        return (a.x - pivot.x) * (b.y - pivot.y) - (a.y - pivot.y) * (b.x - pivot.x);
    }

    Outline outline(const Outline& vertices) const { return vertices; }

    Vertex<T> meet(const Vertex<T>& p, const Vertex<T>& q, const T& cp, const T& cq) const {
        const T t = cp / (cp - cq);
        return {p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, p.z + (q.z - p.z) * t};
    }

    Plane plane(const Plane& computed, const Outline&) const { return computed; }

    Depth depth(const Plane& plane, const auto& point) const {
        return Depth(T(-(plane.a * point.x + plane.b * point.y + plane.d) / plane.c));
    }

    T zero() const { return number(0); }
    T to_step(const T& z, const Plane&, Pixel) const { return z; }
    const T& to_store(const T& z) const { return z; }

    Depth farthest() const {
        if constexpr (has_infinity) {
            return -std::numeric_limits<T>::infinity();
        } else {
            return std::nullopt;
        }
    }

    /// The number that the depth of a plane is.
    T finite(const Depth& z) const {
        if constexpr (has_infinity) {
            return z;
        } else {
            return z.value();
        }
    }

    bool nearer(const auto& z, const Depth& than, const auto& /*at*/) const { return z > than; }

    bool outside(const Box<T>& box, const Window& window) const {
        return box.xmax < number(window.x) || box.ymax < number(window.y) || box.xmin > number(window.right()) ||
               box.ymin > number(window.bottom());
    }

    bool inside(const Box<T>& box, const Window& window) const {
        return box.xmin > number(window.x) && box.ymin > number(window.y) && box.xmax < number(window.right()) &&
               box.ymax < number(window.bottom());
    }

    int first_centre(const T& value, int low, int end) const {
        if (!(value > centre(low))) return low;
        if (value > centre(end - 1)) return end;
        int pixel = whole_part(value, low, end);
        if constexpr (holds_centres) return pixel + int(centre(pixel) < value);
        while (centre(pixel) < value) ++pixel;
        while (centre(pixel - 1) >= value) --pixel;
        return pixel;
    }

    int last_centre(const T& value, int low, int end) const {
        if (!(value >= centre(low))) return low - 1;
        if (value >= centre(end - 1)) return end - 1;
        int pixel = whole_part(value, low, end);
        if constexpr (holds_centres) return pixel - int(centre(pixel) > value);
        while (centre(pixel) > value) --pixel;
        while (centre(pixel + 1) <= value) ++pixel;
        return pixel;
    }

    Rows rows_of(const Outline& outline, int low, int end) const {
        const auto by_y = [](const auto& v, const auto& w) { return v.y < w.y; };
        const auto [top, bottom] = std::minmax_element(outline.begin(), outline.end(), by_y);
        return {first_centre(top->y, low, end), last_centre(bottom->y, low, end) + 1};
    }

    Columns<T> columns_of(const Outline& outline, int row, int low, int end) const {
        const T y = centre(row);
        T left = number(1), right = number(0);
        bool any = false;
        const auto include = [&](const T& x) {
            if (!any || x < left) left = x;
            if (!any || x > right) right = x;
            any = true;
        };
        const auto* from = &outline.back();
        for (const auto& to : outline) {
            const auto& upper = from->y < to.y ? *from : to;
            const auto& lower = from->y < to.y ? to : *from;
            if (y == upper.y) include(upper.x);
            if (y == lower.y) include(lower.x);
            if (upper.y < y && y < lower.y) {
                include(upper.x + (y - upper.y) * (lower.x - upper.x) / (lower.y - upper.y));
            }
            from = &to;
        }
        return {left, right, first_centre(left, low, end), last_centre(right, low, end) + 1};
    }

    int first_column(const auto& end_point, int /*row*/, int low, int end) const {
        return first_centre(end_point.x, low, end);
    }
    int last_column(const auto& end_point, int /*row*/, int low, int end) const {
        return last_centre(end_point.x, low, end);
    }
    bool same_place(const auto& a, const auto& b, int /*row*/) const { return a.x == b.x; }
    bool left_of(const auto& a, const auto& b, int /*row*/) const { return a.x < b.x || (a.x == b.x && a.dx < b.dx); }

    // Used only by the printed text: division by a number that may be zero, equality of rounded values, floor(v + 1/2),
    // and the pixel that holds a number.

    /// Where the numbers have no infinity, b = 0 throws DivisionByZero.
    T divide(const T& a, const T& b) const {
        if constexpr (!has_infinity) {
            if (b == 0) throw DivisionByZero{};
        }
        return a / b;
    }

    Depth depth_of(const T& z) const { return Depth(z); }

    bool same_rounded(const T& v, const T& w) const {
        using std::floor;
        return floor(v + number(0.5)) == floor(w + number(0.5));
    }

    /// Clamped to the pixels that scenes may have, and one more on either side.
    int pixel_of(const T& value) const {
        constexpr int least = -farthest_offset - 1;
        constexpr int most = farthest_offset + largest_side + 1;
        if (!(value > T(least))) return least;
        if (value >= T(most)) return most;
        return whole_part(value, least, most);
    }
};

}  // namespace vidno
