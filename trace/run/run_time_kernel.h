/// RunTimeKernel: float, double, bits, depth and exact as one kernel, for judged and exact runs. It is compiled once
/// for all of these arithmetics.
///
/// A judged run takes every decision three times: by the run's arithmetic on the numbers in use, exactly on the same
/// numbers, and exactly on the truth beside them. The first answer is the run's. The judge hears which of the others
/// differ from it, and may query the numbers behind the decision. Orientation and clip sides are judged by CGAL's
/// predicate, everything else by exact rationals. An exact run takes each decision once.
#pragma once

#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "choice/kernel_choice.h"
#include "format/value.h"
#include "run/followers.h"
#include "run/questions.h"
#include "vidno/kernels/depth_bits.h"

namespace vidno {

/// How a coordinate becomes a number.
struct RunTimeEntry {
    Arithmetic arithmetic;
    const Judge* judge = nullptr;

    RunTimeNumber number(double given) const { return {arithmetic, given, judge}; }
};

/// The formulas in the numbers of an arithmetic; their decisions are not judged.
struct RunTimeNumbers : NumberKernel<RunTimeNumber, RunTimeEntry> {
    using NumberKernel::NumberKernel;

    Sign sign(const RunTimeNumber& value) const { return value.sign(); }

    bool same_rounded(const RunTimeNumber& v, const RunTimeNumber& w) const {
        if (arithmetic.is_exact()) return Exact{}.same_rounded(v.exact().rational(), w.exact().rational());
        const auto rounded = [&](const RunTimeNumber& of) { return std::floor((of + number(0.5)).value()); };
        return rounded(v) == rounded(w);
    }
};

class RunTimeKernel : public RunTimeNumbers {
public:
    static constexpr std::string_view name = "run-time";

    struct Depth {
        std::optional<RunTimeNumber> number;  // none: "no polygon yet", for exact numbers and in a judged run

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

    static Point<Number> flat(const auto& p) { return {p.x, p.y}; }

    // Visits the numbers on which a decision is taken.
    static constexpr auto value_exactly = [](const Number& v) { return Number(ExactNumber(v.value())); };
    static constexpr auto truth_of = [](const Number& v) { return v.exact_truth(); };
    static constexpr auto is_finite = [](const Number& v) { return std::isfinite(v.value()); };
    static constexpr auto is_defined = [](const Number& v) { return v.has_truth(); };
    static constexpr auto is_right = [](const Number& v) { return v.is_right(); };
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
        // In the machine's arithmetic "no polygon yet" is a number, which is not nearer than itself.
        constexpr bool of_machine = std::same_as<decltype(part), std::remove_const_t<decltype(value_of)>>;
        return of_machine ? RunTimeNumbers::Depth(-std::numeric_limits<double>::infinity()) : std::nullopt;
    }

    // Whether a predicate holds for all numbers of an operand.
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

    static Operand constant(const char* called, double value) {
        const Fraction exact = fraction_of(value);
        return {called, exact, exact};
    }
    static void tell_numbers(auto&& tell, const char* called, const Depth& z) {
        if (z.number) return tell(called, *z.number);
        tell.operands.push_back({called, {"-inf"}, {"-inf"}});
    }
    static void tell_numbers(auto&& tell, const char* called, const auto& operand) {
        question::tell_numbers(tell, called, operand);
    }

    /// Two numbers that a question compares.
    struct Pair {
        Number left, right;
        std::optional<int> pixel;
    };

    /// The pairs of numbers that a question compares; the operands are numbers of a kernel.
    template <class Question>
    static std::vector<Pair> compared(const RunTimeNumbers& kernel, const Question& question, const auto&... operands) {
        std::vector<Pair> pairs;
        const auto tell = [&](const Number& left, const Number& right, std::optional<int> pixel = {}) {
            pairs.push_back({left, right, pixel});
        };
        question.compare(kernel, tell, operands...);
        return pairs;
    }

    /// Uses the pair that decides; for a wrong decision, the first pair that the run has in the wrong order.
    Gap deciding(question::Deciding by, Coincidence if_zero, const std::vector<Pair>& exact,
                 const std::vector<Pair>& used, bool is_wrong) const {
        std::vector<Gap> found;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const auto& [left, right, pixel] = exact[i];
            Gap& each = found.emplace_back(
                gap_of(if_zero, left.exact().rational(), right.exact().rational(), arithmetic.digits()));
            each.pixel = pixel;
            each.computed = Value(each.exact.text);
            if (arithmetic.is_exact()) continue;
            if (i >= used.size()) {
                each.computed = Value(std::numeric_limits<double>::quiet_NaN());
                continue;
            }
            const Number other = pixel ? not_judged().centre(*pixel) : used[i].right;
            each.computed = Value((used[i].left - other).value());
            const auto sign = [](double v) { return Sign{int(v > 0) - int(v < 0)}; };
            if (is_wrong && sign(each.computed.number) != each.sign) return each;
        }
        const auto nearer_to_zero = [](const auto& a, const auto& b) { return a.ulps < b.ulps; };
        if (by == question::Deciding::farthest) return *std::max_element(found.begin(), found.end(), nearer_to_zero);
        if (by == question::Deciding::nearest) return *std::min_element(found.begin(), found.end(), nearer_to_zero);
        const auto decides = [](const auto& each) { return each.sign != Sign::zero; };
        const auto first = std::find_if(found.begin(), found.end(), decides);
        return first == found.end() ? found.back() : *first;
    }

    /// The numbers from which a decision was computed.
    template <class Question, class... Asked>
    class Asking final : public Calculator {
    public:
        Asking(const RunTimeKernel& kernel, const Verdict& verdict, const Question& question, const Asked&... operands)
            : kernel_(kernel), verdict_(verdict), question_(question), operands_(operands...) {}

        Operands operands() const override {
            Operands found;
            found.reserve(6);  // the coordinates of an orientation's points
            struct Tell {
                Operands& operands;
                void operator()(const std::string& called, const Number& v) const {
                    operands.push_back(v.operand(called));
                }
            };
            std::size_t i = 0;
            std::apply([&](const auto&... each) { (tell_numbers(Tell{found}, Question::names[i++], each), ...); },
                       operands_);
            question_.constants([&](const char* called, double value) { found.push_back(constant(called, value)); });
            return found;
        }
        std::optional<Gap> gap() const override {
            return std::apply([&](const auto&... each) { return gap(each...); }, operands_);
        }

    private:
        std::optional<Gap> gap(const Asked&... operands) const {
            if (!(all(operands, is_defined) && ...)) return std::nullopt;
            const auto exact = compared(exactly(), question_, mapped(operands, truth_of)...);
            if (exact.empty()) return std::nullopt;
            std::vector<Pair> used;
            const bool has_numbers = (all(operands, is_finite) && ...);
            if (!kernel_.arithmetic.is_exact() && has_numbers) {
                used = compared(kernel_.not_judged(), question_, mapped(operands, value_of)...);
            }
            return kernel_.deciding(Question::deciding, Question::if_zero, exact, used, verdict_.wrong());
        }

        const RunTimeKernel& kernel_;
        const Verdict& verdict_;
        const Question& question_;
        std::tuple<const Asked&...> operands_;
    };

protected:
    bool is_judged() const { return judge != nullptr; }

    /// Takes a decision; in a judged run, three times.
    template <class Question, class... Asked>
    auto decide(const Question& question, const Asked&... operands) const {
        const RunTimeNumbers& numbers = *this;
        if constexpr (!(std::same_as<Asked, Depth> || ...)) {
            if (!is_judged()) return question.answer(numbers, operands...);
        }
        return judged_by(*judge, question, operands...);
    }

    template <class Question, class... Asked>
    auto judged_by(const Judge& to, const Question& question, const Asked&... operands) const {
        Verdict verdict{Question::of, {}, {}};
        const Asking<Question, Asked...> asking(*this, verdict, question, operands...);
        verdict.calculator = &asking;
        if (arithmetic.is_exact()) {
            const auto taken = question.answer(exactly(), mapped(operands, truth_of)...);
            verdict.taken = answer(taken);
            verdict.truth.answer = verdict.taken;
            to(verdict);
            return taken;
        }
        const auto taken = question.answer(not_judged(), mapped(operands, value_of)...);
        verdict.taken = answer(taken);
        if ((all(operands, is_defined) && ...)) {
            verdict.truth.answer = answer(question.answer(exactly(), mapped(operands, truth_of)...));
        }
        // Most operands are their own truth: coordinates of the scene and of windows.
        if ((all(operands, is_right) && ...)) {
            verdict.right_for_operands = !verdict.wrong();
        } else if ((all(operands, is_finite) && ...)) {
            verdict.right_for_operands = taken == question.answer(exactly(), mapped(operands, value_exactly)...);
        }
        to(verdict);
        return taken;
    }

    void survey(const auto& intersection) const {
        const auto& x = intersection.x;
        const auto& y = intersection.y;
        if (!survey_ || arithmetic.is_exact() || !is_defined(x) || !is_defined(y)) return;
        const PointConstructed constructed(x, y);
        const auto off = [](const Number& v) { return nearest_double(Rational(v.value()) - *v.truth()); };
        if (is_finite(x) && is_finite(y)) (*survey_)({std::hypot(off(x), off(y)), &constructed});
    }

public:
    /// The kernel must be one of numbers (Arithmetic::of).
    RunTimeKernel(const NamedKernel& kernel, const Followers& followers)
        : RunTimeNumbers(RunTimeEntry{Arithmetic::of(kernel), followers.hear_sign ? nullptr : followers.judge}),
          survey_(followers.survey),
          hear_sign_(followers.hear_sign),
          judge_of_compared_(followers.hear_sign ? followers.judge : nullptr) {
        if (kernel.kind() == KernelKind::depth) depth_bits_ = DepthBits(kernel.parameter);
    }

    Sign sign(const Number& value) const {
        const Sign taken = value.sign();
        if (hear_sign_) (*hear_sign_)(taken);
        return taken;
    }

    /// The decision is judged once, where the value is computed.
    Number cross(const auto& pivot, const auto& a, const auto& b) const {
        if (is_judged()) {
            decide(question::Orientation{}, flat(pivot), flat(a), flat(b));
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
        return decide(question::Nearer{}, z, than);
    }

    bool outside(const Box<Number>& box, const Window& window) const {
        return decide(question::Outside{{window}}, box);
    }
    bool inside(const Box<Number>& box, const Window& window) const { return decide(question::Inside{{window}}, box); }

    int first_centre(const Number& value, int low, int end) const {
        return decide(question::FirstCentre{{low, end}}, value);
    }
    int last_centre(const Number& value, int low, int end) const {
        return decide(question::LastCentre{{low, end}}, value);
    }
    Rows rows_of(const Outline& outline, int low, int end) const {
        const auto [first, last] = decide(question::RowsOf{{low, end}}, outline);
        return {first, last};
    }
    Columns<Number> columns_of(const Outline& outline, int row, int low, int end) const {
        if (!is_judged()) return RunTimeNumbers::columns_of(outline, row, low, end);
        const auto [first, last] = decide(question::ColumnsOf{{low, end}, row}, outline);
        if (arithmetic.is_exact()) return exactly().columns_of(mapped(outline, truth_of), row, low, end);
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
    bool same_rounded(const Number& v, const Number& w) const { return decide(question::SameRounded{}, v, w); }
    int pixel_of(const Number& value) const { return decide(question::PixelOf{}, value); }

    /// The value in a trace's form.
    static Value reported(const Number& number) {
        return number.is_exact() ? Value(number.exact().fraction()) : Value(number.value());
    }
    static Value reported(const Depth& z) { return z.number ? reported(*z.number) : Value::minus_infinite(); }

protected:
    /// If someone hears the signs of a run, only the comparisons of its numbers are judged: its events report no other
    /// decision.
    void tell_compared(const Number& v, const Number& w) const {
        if (judge_of_compared_) judged_by(*judge_of_compared_, question::Compare{}, v, w);
    }

private:
    std::optional<DepthBits> depth_bits_;
    const Surveyor* survey_;
    const HearSign* hear_sign_;
    const Judge* judge_of_compared_;
};

/// Another name for the kernel, for which OnRegions computes its formulas in the kernel's numbers.
struct RunTimeRegionNumbers : RunTimeKernel {
    explicit RunTimeRegionNumbers(const RunTimeKernel& kernel) : RunTimeKernel(kernel) {}
};

/// For Weiler and Atherton's algorithm, whose decisions are judged as well.
template <>
struct OnRegions<RunTimeKernel> : OnRegions<RunTimeRegionNumbers> {
    using Base = OnRegions<RunTimeRegionNumbers>;

    explicit OnRegions(const RunTimeKernel& kernel) : Base(RunTimeRegionNumbers(kernel)) {}

    bool parallel(const Planes& p, const Planes& q) const {
        return is_judged() ? decide(question::ParallelPlanes{}, p, q) : Base::parallel(p, q);
    }
    bool parallel(const Edge& line, const Edge& other) const {
        return is_judged() ? decide(question::ParallelEdges{}, line, other) : Base::parallel(line, other);
    }

    Sign side(const Edge& line, const Place& p) const {
        return is_judged() ? decide(question::Side{}, line, p) : Base::side(line, p);
    }
    Sign side(const Edge& line, const LoopVertex<Number>& v) const {
        return v.on(line) ? Sign::zero : side(line, v.at);
    }
    bool left_of(const Place& p, const Edge& line) const {
        return is_judged() ? decide(question::LeftOf{}, p, line) : Base::left_of(p, line);
    }

    Place meet(const Edge& line, const Edge& other) const {
        Place found = Base::meet(line, other);
        survey(found);
        return found;
    }

    Sign order(const Place& p, const Place& q) const {
        return is_judged() ? decide(question::Order{}, p, q) : Base::order(p, q);
    }
    Sign order_of_rows(const Place& p, const Place& q) const {
        return is_judged() ? compare(p.y, q.y) : Base::order_of_rows(p, q);
    }
    bool same_place(const LoopVertex<Number>& v, const LoopVertex<Number>& w) const {
        return Base::meet_once(*this, v, w) || order(v.at, w.at) == Sign::zero;
    }

    Sign turn(const Place& pivot, const Place& p, const Place& q) const {
        return is_judged() ? decide(question::Turn{}, pivot, p, q) : Base::turn(pivot, p, q);
    }
    Sign compare(const Number& v, const Number& w) const {
        tell_compared(v, w);
        return is_judged() ? decide(question::Compare{}, v, w) : Base::compare(v, w);
    }
};

}  // namespace vidno
