/// RunTimeKernel: float, double, bits, depth and exact as one kernel, for runs that are recorded or judged. What is compiled is one
/// kernel, whatever it computes with.
///
/// A judged run takes every decision three times: by the run's arithmetic on the numbers in use, exactly on these same
/// numbers, and exactly on the truth beside them. The first answer is the run's; the judge hears which of the others differ from
/// it. Orientation and clip sides are judged by CGAL's predicate, all else by exact rationals.
#pragma once

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "choice/kernel_choice.h"
#include "format/value.h"
#include "run/followers.h"
#include "run/run_time_number.h"
#include "vidno/kernels/depth_bits.h"
#include "vidno/weiler_atherton/weiler_atherton_kernel.h"

namespace vidno {

/// How a coordinate becomes a number.
struct RunTimeEntry {
    Arithmetic arithmetic;
    const Judge* judge = nullptr;

    RunTimeNumber number(double given) const { return {arithmetic, given, judge}; }
};

/// The formulas in numbers of an arithmetic; their decisions are not judged.
struct RunTimeNumbers : NumberKernel<RunTimeNumber, RunTimeEntry> {
    using NumberKernel::NumberKernel;

    Sign sign(const RunTimeNumber& value) const { return value.sign(); }

    bool same_rounded(const RunTimeNumber& v, const RunTimeNumber& w) const {
        if (arithmetic.is_exact()) return Exact{}.same_rounded(v.rational(), w.rational());
        const auto rounded = [&](const RunTimeNumber& of) { return std::floor((of + number(0.5)).value()); };
        return rounded(v) == rounded(w);
    }
};

class RunTimeKernel : public RunTimeNumbers {
public:
    static constexpr std::string_view name = "run-time";

    struct Depth {
        std::optional<RunTimeNumber> number;  // none: "no polygon yet", of exact numbers and of a judged run

        Depth() = default;
        Depth(const RunTimeNumber& z) : number(z) {}
        explicit operator double() const { return number ? double(*number) : -std::numeric_limits<double>::infinity(); }
        friend bool operator<=(const Depth& a, const Depth& b) { return a.number <= b.number; }
    };
    using DepthBuffer = vidno::DepthBuffer<Depth>;

private:
    static constexpr Arithmetic exact_arithmetic{Arithmetic::Kind::exact, 0};

    RunTimeNumbers not_judged() const { return RunTimeNumbers(RunTimeEntry{arithmetic, nullptr}); }
    static RunTimeNumbers exactly() { return RunTimeNumbers(RunTimeEntry{exact_arithmetic, nullptr}); }

    static Answer answer(Sign sign) { return int(sign); }
    static Answer answer(const auto& found) { return found; }

    static Sign orientation(const RunTimeNumbers& kernel, const auto& pivot, const auto& a, const auto& b) {
        if (!kernel.arithmetic.is_exact()) return kernel.sign(kernel.cross(pivot, a, b));
        const auto point = [](const auto& p) {
            return typename CGAL::Simple_cartesian<Rational>::Point_2(p.x.rational(), p.y.rational());
        };
        return Sign{int(CGAL::orientation(point(pivot), point(a), point(b)))};
    }
    static Point<Number> flat(const auto& p) { return {p.x, p.y}; }

    static double off(const Number& v) { return CGAL::to_double(Rational(v.value()) - *v.truth()); }

    // What a decision is taken on, number by number.
    static constexpr auto value_exactly = [](const Number& v) { return Number(Rational(v.value())); };
    static constexpr auto truth_of = [](const Number& v) { return v.exact_truth(); };
    static constexpr auto is_finite = [](const Number& v) { return std::isfinite(v.value()); };
    static constexpr auto is_defined = [](const Number& v) { return v.has_truth(); };
    static constexpr auto value_of = [](const Number& v) { return v.not_judged(); };

    static Number mapped(const Number& v, auto part) { return part(v); }
    static Point<Number> mapped(const Point<Number>& p, auto part) { return {part(p.x), part(p.y)}; }
    static Box<Number> mapped(const Box<Number>& b, auto part) {
        return {part(b.xmin), part(b.ymin), part(b.xmax), part(b.ymax)};
    }
    static vidno::Plane<Number> mapped(const vidno::Plane<Number>& p, auto part) {
        return {part(p.a), part(p.b), part(p.c), part(p.d)};
    }
    static SupportLine<Number> mapped(const SupportLine<Number>& line, auto part) {
        return {part(line.a), part(line.b), mapped(line.on, part)};
    }
    static Outline mapped(const Outline& outline, auto part) {
        Outline vertices;
        for (const auto& v : outline) vertices.push_back({part(v.x), part(v.y), part(v.z)});
        return vertices;
    }
    static RunTimeNumbers::Depth mapped(const Depth& z, auto part) {
        if (z.number) return part(*z.number);
        // To the machine "no polygon yet" is a number, which is not nearer than itself.
        constexpr bool of_machine = std::same_as<decltype(part), std::remove_const_t<decltype(value_of)>>;
        return of_machine ? RunTimeNumbers::Depth(-std::numeric_limits<double>::infinity()) : std::nullopt;
    }

    // Whether something holds for all numbers of an operand.
    static bool all(const Number& v, auto holds) { return holds(v); }
    static bool all(const Point<Number>& p, auto holds) { return holds(p.x) && holds(p.y); }
    static bool all(const Box<Number>& b, auto holds) {
        return holds(b.xmin) && holds(b.ymin) && holds(b.xmax) && holds(b.ymax);
    }
    static bool all(const vidno::Plane<Number>& p, auto holds) {
        return holds(p.a) && holds(p.b) && holds(p.c) && holds(p.d);
    }
    static bool all(const SupportLine<Number>& line, auto holds) {
        return holds(line.a) && holds(line.b) && all(line.on, holds);
    }
    static bool all(const Outline& outline, auto holds) {
        return std::all_of(outline.begin(), outline.end(),
                           [&](const auto& v) { return holds(v.x) && holds(v.y) && holds(v.z); });
    }
    static bool all(const Depth& z, auto holds) { return !z.number || holds(*z.number); }

protected:
    bool is_judged() const { return judge != nullptr; }

    /// Takes `decision(kernel, operands...)`: of a judged run, three times.
    auto decide(Decision of, auto decision, const auto&... operands) const {
        const RunTimeNumbers& numbers = *this;
        if constexpr (!(std::same_as<std::remove_cvref_t<decltype(operands)>, Depth> || ...)) {
            if (!is_judged()) return decision(numbers, operands...);
        }
        const auto taken = decision(not_judged(), mapped(operands, value_of)...);
        Verdict verdict{of, answer(taken), {}};
        if ((all(operands, is_finite) && ...)) {
            verdict.right_for_operands = taken == decision(exactly(), mapped(operands, value_exactly)...);
        }
        if ((all(operands, is_defined) && ...)) {
            verdict.truth.answer = answer(decision(exactly(), mapped(operands, truth_of)...));
        }
        (*judge)(verdict);
        return taken;
    }

    void survey(const auto& intersection) const {
        const auto& x = intersection.x;
        const auto& y = intersection.y;
        if (survey_ && is_defined(x) && is_defined(y) && is_finite(x) && is_finite(y)) {
            (*survey_)(std::hypot(off(x), off(y)));
        }
    }

public:
    /// Throws std::invalid_argument for `filtered` and `grid`: they compare planes and whole numbers.
    RunTimeKernel(const NamedKernel& kernel, const Followers& followers)
        : RunTimeNumbers(RunTimeEntry{arithmetic_of(kernel), followers.judge}),
          survey_(followers.survey),
          hear_sign_(followers.hear_sign) {
        if (kernel.kind() == KernelKind::depth) depth_bits_ = DepthBits(kernel.parameter);
    }

    Sign sign(const Number& value) const {
        const Sign taken = value.sign();
        if (hear_sign_) (*hear_sign_)(taken);
        return taken;
    }

    /// The decision is judged where the value is made, once.
    Number cross(const auto& pivot, const auto& a, const auto& b) const {
        if (is_judged()) {
            const auto side = [](const auto& kernel, const auto&... points) { return orientation(kernel, points...); };
            decide(Decision::orientation, side, flat(pivot), flat(a), flat(b));
        }
        return RunTimeNumbers::cross(pivot, a, b);
    }

    Vertex<Number> meet(const Vertex<Number>& p, const Vertex<Number>& q, const Number& cp, const Number& cq) const {
        Vertex<Number> found = RunTimeNumbers::meet(p, q, cp, cq);
        survey(found);
        return found;
    }

    Number to_store(const Number& z) const {
        return depth_bits_ ? z.with_value(depth_bits_->to_store(z.value())) : z.in(arithmetic, judge);
    }

    Depth depth(const Plane& plane, const auto& point) const { return *RunTimeNumbers::depth(plane, point); }
    Depth depth_of(const Number& z) const { return z.in(arithmetic, judge); }
    Depth farthest() const {
        if (is_judged() || arithmetic.is_exact()) return {};
        return Number::without_truth(arithmetic, -std::numeric_limits<double>::infinity(), nullptr);
    }
    Number finite(const Depth& z) const { return *z.number; }

    bool nearer(const Number& z, const Depth& than, const auto& at) const {
        return is_judged() ? nearer(Depth(z), than, at) : !than.number || z > *than.number;
    }
    bool nearer(const Depth& z, const Depth& than, const auto& at) const {
        if (!is_judged()) return z.number && nearer(*z.number, than, at);
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
        if (!is_judged()) return RunTimeNumbers::columns_of(outline, row, low, end);
        const auto columns = [&](const auto& kernel, const auto& o) {
            const auto found = kernel.columns_of(o, row, low, end);
            return std::pair(found.first, found.end);
        };
        const auto [first, last] = decide(Decision::columns, columns, outline);
        const auto shown = not_judged().columns_of(mapped(outline, value_of), row, low, end);
        const auto undefined = [&](const Number& v) { return Number::without_truth(arithmetic, v.value(), judge); };
        return {undefined(shown.left), undefined(shown.right), first, last};
    }
    int first_column(const auto& end_point, int, int low, int end) const { return first_centre(end_point.x, low, end); }
    int last_column(const auto& end_point, int, int low, int end) const { return last_centre(end_point.x, low, end); }

    // For the printed text

    Number divide(const Number& a, const Number& b) const {
        if (arithmetic.is_exact() && b.sign() == Sign::zero) throw DivisionByZero{};
        return a / b;
    }
    bool same_rounded(const Number& v, const Number& w) const {
        return decide(
            Decision::same_rounded,
            [](const auto& kernel, const auto& a, const auto& b) { return kernel.same_rounded(a, b); }, v, w);
    }
    int pixel_of(const Number& value) const {
        return decide(
            Decision::pixel, [](const auto& kernel, const auto& v) { return kernel.pixel_of(v); }, value);
    }

    /// As a trace tells it.
    static Value told(const Number& number) {
        return number.is_exact() ? Value(Exact::fraction(number.rational())) : Value(number.value());
    }
    static Value told(const Depth& z) { return z.number ? told(*z.number) : Value::minus_infinite(); }

private:
    static Arithmetic arithmetic_of(const NamedKernel& kernel) {
        switch (kernel.kind()) {
            case KernelKind::binary32: return {Arithmetic::Kind::binary32};
            case KernelKind::binary64:
            case KernelKind::depth: return {Arithmetic::Kind::binary64};
            case KernelKind::bits: return {Arithmetic::Kind::bits, kernel.parameter};
            case KernelKind::exact: return exact_arithmetic;
            default: throw std::invalid_argument(kernel.name() + " is no kernel of numbers");
        }
    }

    std::optional<DepthBits> depth_bits_;
    const Surveyor* survey_;
    const HearSign* hear_sign_;
};

/// Another name for the kernel, under which OnRegions works its formulas out in the kernel's numbers.
struct RunTimeRegionNumbers : RunTimeKernel {
    explicit RunTimeRegionNumbers(const RunTimeKernel& kernel) : RunTimeKernel(kernel) {}
};

/// For Weiler and Atherton's algorithm: its decisions are judged as well.
template <>
struct OnRegions<RunTimeKernel> : OnRegions<RunTimeRegionNumbers> {
    using Base = OnRegions<RunTimeRegionNumbers>;
    using Formulas = OnRegions<RunTimeNumbers>;

    explicit OnRegions(const RunTimeKernel& kernel) : Base(RunTimeRegionNumbers(kernel)) {}

    bool parallel(const Planes& p, const Planes& q) const {
        if (!is_judged()) return Base::parallel(p, q);
        const auto are_parallel = [](const RunTimeNumbers& kernel, const auto& a, const auto& b) {
            // A plane of rounded numbers may be upright, which to exact ones is a division by zero.
            const bool divides_by_zero =
                kernel.arithmetic.is_exact() && (a.c.sign() == Sign::zero || b.c.sign() == Sign::zero);
            return !divides_by_zero && Formulas(kernel).parallel(a, b);
        };
        return decide(Decision::parallel, are_parallel, p, q);
    }
    bool parallel(const Edge& line, const Edge& other) const {
        if (!is_judged()) return Base::parallel(line, other);
        return decide(
            Decision::parallel,
            [](const auto& kernel, const auto&... lines) { return Formulas(kernel).parallel(lines...); }, line, other);
    }

    Sign side(const Edge& line, const Place& p) const {
        if (!is_judged()) return Base::side(line, p);
        return decide(
            Decision::orientation,
            [](const auto& kernel, const auto& a, const auto& b) { return Formulas(kernel).side(a, b); }, line, p);
    }
    Sign side(const Edge& line, const LoopVertex<Number>& v) const {
        return v.on(line) ? Sign::zero : side(line, v.at);
    }
    bool left_of(const Place& p, const Edge& line) const {
        if (!is_judged()) return Base::left_of(p, line);
        return decide(
            Decision::left_of,
            [](const auto& kernel, const auto& a, const auto& b) { return Formulas(kernel).left_of(a, b); }, p, line);
    }

    Place meet(const Edge& line, const Edge& other) const {
        Place found = Base::meet(line, other);
        survey(found);
        return found;
    }

    Sign order(const Place& p, const Place& q) const {
        if (!is_judged()) return Base::order(p, q);
        return decide(
            Decision::comparison,
            [](const auto& kernel, const auto&... places) { return Formulas(kernel).order(places...); }, p, q);
    }
    Sign order_of_rows(const Place& p, const Place& q) const { return compare(p.y, q.y); }
    bool same_place(const LoopVertex<Number>& v, const LoopVertex<Number>& w) const {
        return Base::meet_once(*this, v, w) || order(v.at, w.at) == Sign::zero;
    }

    Sign turn(const Place& pivot, const Place& p, const Place& q) const {
        if (!is_judged()) return Base::turn(pivot, p, q);
        return decide(
            Decision::orientation,
            [](const auto& kernel, const auto&... places) { return Formulas(kernel).turn(places...); }, pivot, p, q);
    }
    Sign compare(const Number& v, const Number& w) const {
        if (!is_judged()) return Base::compare(v, w);
        return decide(
            Decision::comparison,
            [](const auto& kernel, const auto&... values) { return Formulas(kernel).compare(values...); }, v, w);
    }
};

}  // namespace vidno
