/// Checked: a kernel whose every decision is judged, while it leads.
///
/// A decision is taken three times: by the machine on the numbers in use, exactly on these same numbers, and exactly on the
/// truth beside them. The first answer is the run's; the judge hears which of the others differ from it. Orientation and
/// clip sides are judged by CGAL's predicate, all else by exact rationals.
#pragma once

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include "shadowed.h"
#include "vidno/weiler_atherton/region.h"

namespace vidno {

/// Hears how far a computed intersection lies from the exact one, in pixels.
using Surveyor = std::function<void(double)>;

/// How a coordinate becomes a number of the machine with its truth beside it.
template <class Machine>
struct Judged {
    Machine machine;
    const Judge* judge;

    Shadowed<typename Machine::Number> number(double given) const {
        return {machine.number(given), Rational(given), judge};
    }
};

template <class Machine>
class Checked : public NumberKernel<Shadowed<typename Machine::Number>, Judged<Machine>> {
    using T = typename Machine::Number;
    using Base = NumberKernel<Shadowed<T>, Judged<Machine>>;

public:
    using Number = Shadowed<T>;
    using Outline = typename Base::Outline;

    static constexpr std::string_view name = Machine::name;
    static constexpr bool has_infinity = true;

    struct Depth {
        std::optional<Number> number;  // none: "no polygon yet"

        Depth() = default;
        Depth(const Number& z) : number(z) {}
        explicit operator double() const { return number ? double(*number) : -std::numeric_limits<double>::infinity(); }
        friend bool operator<=(const Depth& a, const Depth& b) { return a.number <= b.number; }
    };
    using DepthBuffer = vidno::DepthBuffer<Depth>;

    Checked(Machine machine, const Judge& judge, const Surveyor& surveyor)
        : Base(Judged<Machine>{std::move(machine), &judge}), surveyor_(&surveyor) {}

    /// The decision is judged where the value is made, once.
    Number cross(const auto& pivot, const auto& a, const auto& b) const {
        const auto side = [](const auto& kernel, const auto&... points) { return orientation(kernel, points...); };
        decide(Decision::orientation, side, flat(pivot), flat(a), flat(b));
        return Base::cross(pivot, a, b);
    }
    Sign sign(const Number& cross) const { return machine().sign(cross.value); }

    Vertex<Number> meet(const Vertex<Number>& p, const Vertex<Number>& q, const Number& cp, const Number& cq) const {
        Vertex<Number> found = Base::meet(p, q, cp, cq);
        survey(found);
        return found;
    }

    Number to_store(const Number& z) const { return {machine().to_store(z.value), z.exact, z.judge}; }

    Depth depth(const typename Base::Plane& plane, const auto& point) const { return *Base::depth(plane, point); }
    Depth depth_of(const Number& z) const { return z; }
    Depth farthest() const { return {}; }
    Number finite(const Depth& z) const { return *z.number; }
    bool nearer(const Depth& z, const Depth& than, const auto& /*at*/) const {
        const auto nearer_one = [](const auto& kernel, const auto& a, const auto& b) {
            return kernel.nearer(a, b, Pixel{});
        };
        return decide(Decision::nearer, nearer_one, z, than);
    }

    bool outside(const Box<Number>& box, const Window& window) const {
        return decide(
            Decision::outside, [&](const auto& kernel, const auto& b) { return kernel.outside(b, window); }, box);
    }
    bool inside(const Box<Number>& box, const Window& window) const {
        return decide(
            Decision::inside, [&](const auto& kernel, const auto& b) { return kernel.inside(b, window); }, box);
    }

    int first_centre(const Number& value, int low, int end) const {
        return decide(
            Decision::first_centre, [&](const auto& kernel, const auto& v) { return kernel.first_centre(v, low, end); },
            value);
    }
    int last_centre(const Number& value, int low, int end) const {
        return decide(
            Decision::last_centre, [&](const auto& kernel, const auto& v) { return kernel.last_centre(v, low, end); },
            value);
    }
    Rows rows_of(const Outline& outline, int low, int end) const {
        const auto rows = [&](const auto& kernel, const auto& o) {
            const Rows found = kernel.rows_of(o, low, end);
            return std::pair(found.first, found.end);
        };
        const auto [first, last] = decide(Decision::rows, rows, outline);
        return {first, last};
    }
    Columns<Number> columns_of(const Outline& outline, int row, int low, int end) const {
        const auto columns = [&](const auto& kernel, const auto& o) {
            const auto found = kernel.columns_of(o, row, low, end);
            return std::pair(found.first, found.end);
        };
        const auto [first, last] = decide(Decision::columns, columns, outline);
        const auto shown = machine().columns_of(mapped(outline, value_of), row, low, end);
        return {Number(shown.left, std::nullopt, &judge()), Number(shown.right, std::nullopt, &judge()), first, last};
    }
    int first_column(const auto& end_point, int, int low, int end) const { return first_centre(end_point.x, low, end); }
    int last_column(const auto& end_point, int, int low, int end) const { return last_centre(end_point.x, low, end); }
    bool same_place(const auto& a, const auto& b, int) const { return a.x == b.x; }
    bool left_of(const auto& a, const auto& b, int) const { return a.x < b.x || (a.x == b.x && a.dx < b.dx); }

    // Of the printed text
    Number divide(const Number& a, const Number& b) const { return a / b; }
    bool same_rounded(const Number& v, const Number& w) const {
        return decide(
            Decision::same_rounded,
            [](const auto& kernel, const auto& a, const auto& b) { return kernel.same_rounded(a, b); }, v, w);
    }
    int pixel_of(const Number& value) const {
        return decide(
            Decision::pixel, [](const auto& kernel, const auto& v) { return kernel.pixel_of(v); }, value);
    }

protected:
    /// Takes `decision(kernel, operands...)`, thrice.
    auto decide(Decision of, auto decision, const auto&... operands) const {
        const auto taken = decision(machine(), mapped(operands, value_of)...);
        Verdict verdict{of, answer(taken), {}};
        if ((all(operands, is_finite) && ...)) {
            verdict.right_for_operands = taken == decision(exact_, mapped(operands, value_exactly)...);
        }
        if ((all(operands, is_defined) && ...)) {
            verdict.truth.answer = answer(decision(exact_, mapped(operands, truth_of)...));
        }
        judge()(verdict);
        return taken;
    }

    void survey(const auto& intersection) const {
        const auto& x = intersection.x;
        const auto& y = intersection.y;
        if (x.exact && y.exact && is_finite(x) && is_finite(y)) (*surveyor_)(std::hypot(off(x), off(y)));
    }

private:
    const Machine& machine() const { return Base::machine; }
    const Judge& judge() const { return *Base::judge; }

    static Answer answer(Sign sign) { return int(sign); }
    static Answer answer(const auto& found) { return found; }

    static Sign orientation(const Machine& kernel, const auto& pivot, const auto& a, const auto& b) {
        return kernel.sign(kernel.cross(pivot, a, b));
    }
    static Sign orientation(const Exact&, const auto& pivot, const auto& a, const auto& b) {
        const auto point = [](const auto& p) { return typename CGAL::Simple_cartesian<Rational>::Point_2(p.x, p.y); };
        return Sign{int(CGAL::orientation(point(pivot), point(a), point(b)))};
    }
    static Point<Number> flat(const auto& p) { return {p.x, p.y}; }

    static double off(const Number& v) { return CGAL::to_double(value_exactly(v) - *v.exact); }

    // What a decision is taken on, number by number.
    static constexpr auto value_of = [](const Number& v) { return v.value; };
    static constexpr auto value_exactly = [](const Number& v) { return Rational(double(v.value)); };
    static constexpr auto truth_of = [](const Number& v) { return *v.exact; };
    static constexpr auto is_finite = [](const Number& v) { return std::isfinite(double(v.value)); };
    static constexpr auto is_defined = [](const Number& v) { return v.exact.has_value(); };

    template <class F>
    using Part = std::invoke_result_t<F, const Number&>;

    static auto mapped(const Number& v, auto part) { return part(v); }
    static auto mapped(const Point<Number>& p, auto part) { return Point<Part<decltype(part)>>{part(p.x), part(p.y)}; }
    static auto mapped(const Box<Number>& b, auto part) {
        return Box<Part<decltype(part)>>{part(b.xmin), part(b.ymin), part(b.xmax), part(b.ymax)};
    }
    static auto mapped(const vidno::Plane<Number>& p, auto part) {
        return vidno::Plane<Part<decltype(part)>>{part(p.a), part(p.b), part(p.c), part(p.d)};
    }
    static auto mapped(const SupportLine<Number>& line, auto part) {
        return SupportLine<Part<decltype(part)>>{part(line.a), part(line.b), mapped(line.on, part)};
    }
    static auto mapped(const Outline& outline, auto part) {
        std::vector<Vertex<Part<decltype(part)>>> vertices;
        for (const auto& v : outline) vertices.push_back({part(v.x), part(v.y), part(v.z)});
        return vertices;
    }
    auto mapped(const Depth& z, auto part) const {
        if constexpr (std::same_as<Part<decltype(part)>, T>) {
            return z.number ? part(*z.number) : machine().farthest();
        } else {
            return z.number ? Exact::Depth(part(*z.number)) : Exact::Depth();
        }
    }
    bool all(const auto& operand, auto holds) const {
        bool each = true;
        if constexpr (std::same_as<std::remove_cvref_t<decltype(operand)>, Depth>) {
            return !operand.number || holds(*operand.number);
        } else {
            mapped(operand, [&](const Number& v) {
                each = each && holds(v);
                return 0;
            });
            return each;
        }
    }

    static constexpr Exact exact_{};
    const Surveyor* surveyor_;
};

}  // namespace vidno
