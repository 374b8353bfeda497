#include <map>

#include "format/rational_text.h"
#include "say/decision.h"
#include "say/numbers.h"
#include "say/words.h"

namespace vidno::say {

namespace {

using Lines = std::vector<std::string>;

Lines operator+(Lines one, const Lines& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

Sign sign_of(const Rational& number) { return number < 0 ? Sign::negative : Sign{number > 0}; }

Rational floor_of(const Rational& number) {
    using Fractions = CGAL::Fraction_traits<Rational>;
    Fractions::Numerator_type p, q;
    Fractions::Decompose()(number, p, q);
    const Rational quotient = Fractions::Compose()(p / q, Fractions::Denominator_type(1));  // towards zero
    return quotient > number ? Rational(quotient - 1) : quotient;
}

/// As written by hand: 3 for 3/1, with a real minus sign.
std::string text_of(const Rational& number) { return all_digits(Value(Exact::fraction(number)), Language::english); }

/// In brackets if it would be ambiguous beside an operator.
std::string inner(const Rational& number) {
    const std::string text = text_of(number);
    return number < 0 || text.find('/') != text.npos ? "(" + text + ")" : text;
}

std::string with_zero(const Rational& value) {
    if (value == 0) return "= 0";
    return "= " + text_of(value) + " " + std::string(relation_of(sign_of(value))) + " 0";
}

/// The calculations of decisions whose operands have these values.
class ByHand {
public:
    std::map<std::string, Rational, std::less<>> numbers;
    Language language;
    std::string other;

    Lines lines_of(Decision of) const {
        switch (of) {
            case Decision::orientation: return has("pivot.x") ? turn() : side();
            case Decision::left_of: return side() + Lines{compared("a", at("line.a"), "0", 0)};
            case Decision::nearer: return pair("z", "against");
            case Decision::comparison: return has("a") ? pair("a", "b") : points();
            case Decision::parallel: return has("p.c") ? planes() : edges();
            case Decision::outside:
            case Decision::inside: return box();
            case Decision::first_centre: return first("x", at("x"));
            case Decision::last_centre: return last("x", at("x"));
            case Decision::columns:
                return has("left") ? first("left", at("left")) + last("right", at("right")) : columns();
            case Decision::rows: return rows();
            case Decision::visibility:
                return (has("upper") ? pair("y", "upper") : Lines{}) + (has("lower") ? pair("y", "lower") : Lines{});
            case Decision::same_rounded: return {rounded("v"), rounded("w")};
            case Decision::pixel: return {"⌊v⌋ = ⌊" + text_of(at("v")) + "⌋ = " + text_of(floor_of(at("v")))};
        }
        return {};
    }

private:
    static inline const Rational half{0.5};

    bool has(std::string_view name) const { return numbers.contains(name); }
    const Rational& at(std::string_view name) const {
        const auto found = numbers.find(name);
        if (found == numbers.end()) throw std::out_of_range("no operand " + std::string(name));
        return found->second;
    }

    /// The name of an operand in the listings, or a word for it.
    std::string named(std::string_view name) const {
        if (name == "against") return other;
        if (name == "left") return "x₁";
        if (name == "right") return "x₂";
        if (name == "upper") return std::string(Bilingual{"upper", "верхний"}.in(language));
        if (name == "lower") return std::string(Bilingual{"lower", "нижний"}.in(language));
        return std::string(name);
    }

    static std::string compared(const std::string& a_name, const Rational& a, const std::string& b_name,
                                const Rational& b) {
        return a_name + " " + std::string(relation_of(sign_of(a - b))) + " " + b_name;
    }
    Lines pair(std::string_view one, std::string_view second) const {
        const Rational &a = at(one), &b = at(second);
        const std::string a_name = named(one), b_name = named(second);
        return {a_name + " = " + text_of(a), b_name + " = " + text_of(b),
                a_name + " − " + b_name + " " + with_zero(a - b), compared(a_name, a, b_name, b)};
    }
    Lines points() const {
        const Lines by_x = pair("p.x", "q.x");
        return at("p.x") == at("q.x") ? by_x + pair("p.y", "q.y") : by_x;
    }

    /// The sum or the difference of two products.
    static Lines products(const std::string& formula, const std::array<Rational, 4>& factors, bool is_sum) {
        const auto& [a, b, c, d] = factors;
        const Rational left = a * b, right = c * d;
        const std::string sign = is_sum ? " + " : " − ";
        return {"f = " + formula, "= " + inner(a) + " · " + inner(b) + sign + inner(c) + " · " + inner(d),
                "= " + text_of(left) + sign + inner(right), with_zero(left + (is_sum ? right : Rational(-right)))};
    }
    Lines turn() const {
        const auto way = [&](const char* to, const char* axis) {
            return Rational(at(std::string(to) + axis) - at(std::string("pivot") + axis));
        };
        return products("(aₓ − oₓ) (bᵧ − oᵧ) − (aᵧ − oᵧ) (bₓ − oₓ)",
                        {way("a", ".x"), way("b", ".y"), way("a", ".y"), way("b", ".x")}, false);
    }
    Lines side() const {
        return products("a (pₓ − x) + b (pᵧ − y)",
                        {at("line.a"), at("p.x") - at("line.x"), at("line.b"), at("p.y") - at("line.y")}, true);
    }
    Lines edges() const {
        return products("p.a · q.b − p.b · q.a", {at("p.a"), at("q.b"), at("p.b"), at("q.a")}, false);
    }
    Lines planes() const {
        Lines lines;
        for (const std::string name : {"a", "b"}) {
            if (at("p.c") == 0 || at("q.c") == 0) {
                lines.emplace_back("c = 0");
                continue;
            }
            const Rational p = at("p." + name) / at("p.c"), q = at("q." + name) / at("q.c");
            lines.push_back("q." + name + " / q.c − p." + name + " / p.c = " + text_of(q) + " − " + inner(p) + " " +
                            with_zero(q - p));
        }
        return lines;
    }
    Lines box() const {
        Lines lines;
        if (!has("window.xmin")) return lines;
        constexpr std::pair<std::string_view, std::string_view> sides[] = {
            {"xmax", "xmin"}, {"ymax", "ymin"}, {"xmin", "xmax"}, {"ymin", "ymax"},
            {"xmin", "xmin"}, {"ymin", "ymin"}, {"xmax", "xmax"}, {"ymax", "ymax"}};
        for (const auto& [own, of_window] : sides) {
            const std::string name = "box." + std::string(own), second = "window." + std::string(of_window);
            const Rational &a = at(name), &b = at(second);
            lines.push_back(name + " = " + compared(text_of(a), a, text_of(b), b) + " = " + second);
        }
        return lines;
    }
    std::string rounded(const std::string& name) const {
        const Rational moved = at(name) + half;
        return "⌊" + name + " + 1/2⌋ = ⌊" + text_of(moved) + "⌋ = " + text_of(floor_of(moved));
    }

    /// A pixel, and where the range from `low` to before `end`, moved by `by`, ends before it.
    std::string within(const Rational& pixel, int by) const {
        const Rational lowest = floor_of(at("low")) + (by < 0 ? by : 0), highest = floor_of(at("end")) + by;
        const Rational& found = pixel < lowest ? lowest : pixel > highest ? highest : pixel;
        return found == pixel ? text_of(pixel) : text_of(pixel) + " → " + text_of(found);
    }
    /// The first i with i + 1/2 >= x, from `low` to `end`.
    Lines first(std::string_view name, const Rational& x) const {
        const Rational least = x - half;
        return {named(name) + " = " + text_of(x), "i + 1/2 ≥ " + text_of(x) + " ⇒ i = ⌈" + text_of(least) +
                                                      "⌉ = " + within(Rational(-floor_of(-least)), 0)};
    }
    /// The last i with i + 1/2 <= x, from `low` - 1 to `end` - 1.
    Lines last(std::string_view name, const Rational& x) const {
        const Rational most = x - half;
        return {named(name) + " = " + text_of(x),
                "i + 1/2 ≤ " + text_of(x) + " ⇒ i = ⌊" + text_of(most) + "⌋ = " + within(floor_of(most), -1)};
    }

    std::vector<Point<Rational>> outline() const {
        std::vector<Point<Rational>> vertices;
        for (int i = 0; has("v" + std::to_string(i) + ".x"); ++i) {
            const std::string name = "v" + std::to_string(i);
            vertices.push_back({at(name + ".x"), at(name + ".y")});
        }
        return vertices;
    }
    Lines first_and_last(const char* first_name, const char* last_name, const std::vector<Rational>& found) const {
        if (found.empty()) return {};
        const auto [least, most] = std::minmax_element(found.begin(), found.end());
        return first(first_name, *least) + last(last_name, *most);
    }
    Lines rows() const {
        std::vector<Rational> heights;
        for (const auto& vertex : outline()) heights.push_back(vertex.y);
        return first_and_last("min y", "max y", heights);
    }
    Lines columns() const {
        const Rational y = at("row") + half;
        std::vector<Rational> met;
        Lines lines{"y = " + text_of(y)};
        const auto vertices = outline();
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const std::size_t next = (i + 1) % vertices.size();
            const auto &from = vertices[i], &to = vertices[next];
            const Rational before = y - from.y, after = y - to.y;
            if (before * after > 0) continue;
            const std::string edge = "v" + std::to_string(i) + " v" + std::to_string(next) + ": x = ";
            if (from.y == to.y) {
                met.insert(met.end(), {from.x, to.x});
                lines.push_back(edge + text_of(from.x) + ", " + text_of(to.x));
                continue;
            }
            const Rational x = from.x + before * (to.x - from.x) / (to.y - from.y);
            met.push_back(x);
            lines.push_back(edge + text_of(from.x) + " + " + inner(before) + " · " + inner(Rational(to.x - from.x)) +
                            " / " + inner(Rational(to.y - from.y)) + " = " + text_of(x));
        }
        return lines + first_and_last("min x", "max x", met);
    }
};

/// With the run's operands, or with the exact ones.
Lines lines_with(Fraction Operand::*which, Decision of, const Operands& operands, Language language,
                 const std::string& other) {
    ByHand by_hand{{}, language, other};
    for (const auto& operand : operands) {
        const auto number = rational_in((operand.*which).text);
        if (!number) {
            return {std::string(
                Bilingual{"One of the numbers is undefined or infinite.", "Одно из чисел не определено или бесконечно."}
                    .in(language))};
        }
        by_hand.numbers.emplace(operand.name, *number);
    }
    return by_hand.lines_of(of);
}

}  // namespace

std::vector<Calculation> calculations(Decision of, const Operands& operands, Language language,
                                      const std::string& other) {
    constexpr Bilingual by_hand{"Step by step", "Вычисление по шагам"},
        of_run{"Step by step with the numbers of this run", "Вычисление по шагам с числами этого прогона"},
        exactly{"Step by step with the exact numbers", "Вычисление по шагам с точными числами"};
    const bool has_drifted =
        std::any_of(operands.begin(), operands.end(), [](const Operand& each) { return each.used != each.exact; });
    std::vector<Calculation> made;
    const auto add = [&](const Bilingual& title, Fraction Operand::*which) {
        Lines lines = lines_with(which, of, operands, language, other);
        if (!lines.empty()) made.push_back({std::string(title.in(language)), std::move(lines)});
    };
    if (has_drifted) add(of_run, &Operand::used);
    add(has_drifted ? exactly : by_hand, &Operand::exact);
    return made;
}

}  // namespace vidno::say
