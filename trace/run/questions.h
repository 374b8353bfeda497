/// Questions: the decisions of a run as a judge sees them.
///
/// A question has the answer, computed in numbers of any arithmetic; the names of its operands; and the pairs of
/// numbers whose comparison determines the answer. It reports each pair as `tell(left, right)`, or with the column or
/// row whose centre is the right number.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "run/run_time_number.h"
#include "vidno/weiler_atherton/weiler_atherton_kernel.h"

namespace vidno::question {

/// The pair that decides, if a question has several.
enum class Deciding {
    nearest,   // the one whose numbers are closest to each other: any pair may change the answer
    farthest,  // the one whose numbers are farthest apart: all must be equal
    first      // the first of numbers that are not equal
};

/// Reports the numbers of an operand, `tell(name, number)`.
void tell_numbers(auto&& tell, const std::string& name, const RunTimeNumber& v) { tell(name, v); }
void tell_numbers(auto&& tell, const std::string& name, const Point<RunTimeNumber>& p) {
    tell(name + ".x", p.x);
    tell(name + ".y", p.y);
}
void tell_numbers(auto&& tell, const std::string& name, const Box<RunTimeNumber>& box) {
    tell(name + ".xmin", box.xmin);
    tell(name + ".ymin", box.ymin);
    tell(name + ".xmax", box.xmax);
    tell(name + ".ymax", box.ymax);
}
void tell_numbers(auto&& tell, const std::string& name, const Plane<RunTimeNumber>& plane) {
    tell(name + ".a", plane.a);
    tell(name + ".b", plane.b);
    tell(name + ".c", plane.c);
    tell(name + ".d", plane.d);
}
void tell_numbers(auto&& tell, const std::string& name, const SupportLine<RunTimeNumber>& line) {
    tell(name + ".a", line.a);
    tell(name + ".b", line.b);
    tell(name + ".x", line.on.x);
    tell(name + ".y", line.on.y);
}
void tell_numbers(auto&& tell, const std::string& name, const std::vector<Vertex<RunTimeNumber>>& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        tell(name + std::to_string(i) + ".x", outline[i].x);
        tell(name + std::to_string(i) + ".y", outline[i].y);
    }
}

/// The kind of the decision, the meaning of equal numbers, and the pair that decides.
template <Decision decision, Coincidence coincidence, Deciding pair = Deciding::nearest>
struct Question {
    static constexpr Decision of = decision;
    static constexpr Coincidence if_zero = coincidence;
    static constexpr Deciding deciding = pair;

    /// Reports the whole numbers that a question has besides its operands, `tell(name, number)`.
    static void constants(auto&&) {}
};

/// On which side of the line from the pivot to a does b lie?
struct Orientation : Question<Decision::orientation, Coincidence::point_on_line> {
    static constexpr std::array names{"pivot", "a", "b"};

    static Sign answer(const auto& kernel, const auto& pivot, const auto& a, const auto& b) {
        if (!kernel.arithmetic.is_exact()) return kernel.sign(kernel.cross(pivot, a, b));
        const auto side = [&]<class Kernel>(Kernel, const auto& number) {
            const auto point = [&](const auto& p) {
                return typename Kernel::Point_2(number(p.x.exact()), number(p.y.exact()));
            };
            return Sign{int(CGAL::orientation(point(pivot), point(a), point(b)))};
        };
        const auto are_doubles = [](const auto&... p) {
            return ((p.x.exact().as_double() && p.y.exact().as_double()) && ...);
        };
        if (are_doubles(pivot, a, b)) {
            return side(CGAL::Exact_predicates_inexact_constructions_kernel(),
                        [](const ExactNumber& v) { return *v.as_double(); });
        }
        return side(CGAL::Simple_cartesian<Rational>(), [](const ExactNumber& v) { return v.rational(); });
    }
    static void compare(const auto&, auto&& tell, const auto& pivot, const auto& a, const auto& b) {
        tell((a.x - pivot.x) * (b.y - pivot.y), (a.y - pivot.y) * (b.x - pivot.x));
    }
};

/// Is the depth z nearer than another?
struct Nearer : Question<Decision::nearer, Coincidence::equal_depths> {
    static constexpr std::array names{"z", "against"};

    static bool answer(const auto& kernel, const auto& z, const auto& against) {
        return kernel.nearer(z, against, Pixel{});
    }
    static void compare(const auto&, auto&& tell, const auto& z, const auto& against) {
        if (z && against) tell(*z, *against);
    }
};

/// How does a box lie in relation to a window?
struct OfWindow {
    static constexpr Coincidence if_zero = Coincidence::box_on_window;
    static constexpr Deciding deciding = Deciding::nearest;
    static constexpr std::array names{"box"};

    const Window& window;

    void constants(auto&& tell) const {
        tell("window.xmin", window.x);
        tell("window.ymin", window.y);
        tell("window.xmax", window.right());
        tell("window.ymax", window.bottom());
    }
};

struct Outside : OfWindow {
    static constexpr Decision of = Decision::outside;

    bool answer(const auto& kernel, const auto& box) const { return kernel.outside(box, window); }
    void compare(const auto& kernel, auto&& tell, const auto& box) const {
        tell(kernel.number(window.x), box.xmax);
        tell(kernel.number(window.y), box.ymax);
        tell(box.xmin, kernel.number(window.right()));
        tell(box.ymin, kernel.number(window.bottom()));
    }
};

struct Inside : OfWindow {
    static constexpr Decision of = Decision::inside;

    bool answer(const auto& kernel, const auto& box) const { return kernel.inside(box, window); }
    void compare(const auto& kernel, auto&& tell, const auto& box) const {
        tell(box.xmin, kernel.number(window.x));
        tell(box.ymin, kernel.number(window.y));
        tell(kernel.number(window.right()), box.xmax);
        tell(kernel.number(window.bottom()), box.ymax);
    }
};

/// Which pixel of low <= i < end has its centre next to a number?
struct OfCentres {
    static constexpr Coincidence if_zero = Coincidence::on_pixel_centre;
    static constexpr Deciding deciding = Deciding::nearest;

    int low, end;

    void constants(auto&& tell) const {
        tell("low", low);
        tell("end", end);
    }

protected:
    /// Compares the number with the nearest centre of the range.
    void compare_with_centre(const auto& kernel, auto&& tell, const auto& value) const {
        const double near = double(value);
        const double pixel = std::isnan(near) ? low : std::clamp(std::floor(near), double(low), double(end - 1));
        tell(value, kernel.centre(int(pixel)), int(pixel));
    }
};

struct FirstCentre : OfCentres {
    static constexpr Decision of = Decision::first_centre;
    static constexpr std::array names{"x"};

    int answer(const auto& kernel, const auto& value) const { return kernel.first_centre(value, low, end); }
    void compare(const auto& kernel, auto&& tell, const auto& value) const { compare_with_centre(kernel, tell, value); }
};

struct LastCentre : OfCentres {
    static constexpr Decision of = Decision::last_centre;
    static constexpr std::array names{"x"};

    int answer(const auto& kernel, const auto& value) const { return kernel.last_centre(value, low, end); }
    void compare(const auto& kernel, auto&& tell, const auto& value) const { compare_with_centre(kernel, tell, value); }
};

/// Which rows have their centres between the ends of an outline?
struct RowsOf : OfCentres {
    static constexpr Decision of = Decision::rows;
    static constexpr std::array names{"v"};

    std::pair<int, int> answer(const auto& kernel, const auto& outline) const {
        const Rows found = kernel.rows_of(outline, low, end);
        return {found.first, found.end};
    }
    void compare(const auto& kernel, auto&& tell, const auto& outline) const {
        const auto by_y = [](const auto& v, const auto& w) { return v.y < w.y; };
        const auto [top, bottom] = std::minmax_element(outline.begin(), outline.end(), by_y);
        compare_with_centre(kernel, tell, top->y);
        compare_with_centre(kernel, tell, bottom->y);
    }
};

/// Which columns does an outline have on a row?
struct ColumnsOf : OfCentres {
    static constexpr Decision of = Decision::columns;
    static constexpr std::array names{"v"};

    int row;

    void constants(auto&& tell) const {
        tell("row", row);
        OfCentres::constants(tell);
    }
    std::pair<int, int> answer(const auto& kernel, const auto& outline) const {
        const auto found = kernel.columns_of(outline, row, low, end);
        return {found.first, found.end};
    }
    void compare(const auto& kernel, auto&& tell, const auto& outline) const {
        const auto found = kernel.columns_of(outline, row, low, end);
        if (found.left > found.right) return;
        compare_with_centre(kernel, tell, found.left);
        compare_with_centre(kernel, tell, found.right);
    }
};

/// In the printed text: are two numbers equal once they are rounded?
struct SameRounded : Question<Decision::same_rounded, Coincidence::on_pixel_centre> {
    static constexpr std::array names{"v", "w"};

    static bool answer(const auto& kernel, const auto& v, const auto& w) { return kernel.same_rounded(v, w); }
    static void compare(const auto& kernel, auto&& tell, const auto& v, const auto& w) {
        for (const auto* each : {&v, &w}) tell(*each, kernel.number(std::floor(double(*each)) + 0.5));
    }
};

/// In the printed text: which pixel holds a number?
struct PixelOf : Question<Decision::pixel, Coincidence::equal_numbers> {
    static constexpr std::array names{"v"};

    static int answer(const auto& kernel, const auto& value) { return kernel.pixel_of(value); }
    static void compare(const auto& kernel, auto&& tell, const auto& value) {
        tell(value, kernel.number(std::round(double(value))));
    }
};

// Weiler and Atherton's algorithm

template <class Kernel>
OnRegions<Kernel> regions(const Kernel& kernel) {
    return OnRegions<Kernel>(kernel);
}

struct ParallelPlanes : Question<Decision::parallel, Coincidence::parallel_lines, Deciding::farthest> {
    static constexpr std::array names{"p", "q"};

    static bool answer(const auto& kernel, const auto& p, const auto& q) {
        return !divides_by_zero(kernel, p, q) && regions(kernel).parallel(p, q);
    }
    static void compare(const auto& kernel, auto&& tell, const auto& p, const auto& q) {
        if (divides_by_zero(kernel, p, q)) return;
        tell(q.a / q.c, p.a / p.c);
        tell(q.b / q.c, p.b / p.c);
    }

private:
    /// A plane in rounded numbers may be vertical, which is a division by zero in exact ones.
    static bool divides_by_zero(const auto& kernel, const auto& p, const auto& q) {
        return kernel.arithmetic.is_exact() && (p.c.sign() == Sign::zero || q.c.sign() == Sign::zero);
    }
};

struct ParallelEdges : Question<Decision::parallel, Coincidence::parallel_lines> {
    static constexpr std::array names{"p", "q"};

    static bool answer(const auto& kernel, const auto& p, const auto& q) { return regions(kernel).parallel(p, q); }
    static void compare(const auto&, auto&& tell, const auto& p, const auto& q) { tell(p.a * q.b, p.b * q.a); }
};

/// On which side of a line does a point lie?
struct Side : Question<Decision::orientation, Coincidence::point_on_line> {
    static constexpr std::array names{"line", "p"};

    static Sign answer(const auto& kernel, const auto& line, const auto& p) { return regions(kernel).side(line, p); }
    static void compare(const auto&, auto&& tell, const auto& line, const auto& p) {
        tell(line.a * (p.x - line.on.x), -(line.b * (p.y - line.on.y)));
    }
};

struct LeftOf : Question<Decision::left_of, Coincidence::point_on_line> {
    static constexpr std::array names{"p", "line"};

    static bool answer(const auto& kernel, const auto& p, const auto& line) { return regions(kernel).left_of(p, line); }
    static void compare(const auto& kernel, auto&& tell, const auto& p, const auto& line) {
        Side::compare(kernel, tell, line, p);
    }
};

/// By x and then by y.
struct Order : Question<Decision::comparison, Coincidence::shared_points, Deciding::first> {
    static constexpr std::array names{"p", "q"};

    static Sign answer(const auto& kernel, const auto& p, const auto& q) { return regions(kernel).order(p, q); }
    static void compare(const auto&, auto&& tell, const auto& p, const auto& q) {
        tell(p.x, q.x);
        tell(p.y, q.y);
    }
};

struct Turn : Orientation {
    static Sign answer(const auto& kernel, const auto& pivot, const auto& p, const auto& q) {
        return regions(kernel).turn(pivot, p, q);
    }
};

struct Compare : Question<Decision::comparison, Coincidence::equal_numbers> {
    static constexpr std::array names{"a", "b"};

    static Sign answer(const auto& kernel, const auto& v, const auto& w) { return regions(kernel).compare(v, w); }
    static void compare(const auto&, auto&& tell, const auto& v, const auto& w) { tell(v, w); }
};

}  // namespace vidno::question
