/// The parser is here, not in a library, because the program and the page must accept the same formulas, and no library
/// is available to both.
#include "scene/height_function.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "refused.h"
#include "scene/elementary.h"

namespace vidno {

namespace {

/// Bounds how deep parsing and evaluation nest.
constexpr std::size_t most_characters = 1000;

template <class T>
struct Named {
    std::string_view name;
    T value;
};

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);

#define VIDNO_NAMED(name) {#name, elementary::name},
constexpr auto functions_of_one = std::to_array<Named<OfOne>>({
    VIDNO_ELEMENTARY(VIDNO_NAMED)  //
    {"ln", elementary::log},
    {"sqrt", [](double v) { return std::sqrt(v); }},
    {"abs", [](double v) { return std::abs(v); }},
    {"sign", [](double v) { return double(v > 0) - double(v < 0); }},
    {"floor", [](double v) { return std::floor(v); }},
    {"ceil", [](double v) { return std::ceil(v); }},
    {"rint", [](double v) { return std::floor(v + 0.5); }},
});
#undef VIDNO_NAMED

constexpr auto functions_of_two = std::to_array<Named<OfTwo>>({{"atan2", elementary::atan2}, {"pow", elementary::pow}});

/// For the functions of one or more arguments, which are taken from the left; `avg` is the sum, divided at the end.
constexpr auto functions_of_many = std::to_array<Named<OfTwo>>({
    {"min", [](double a, double b) { return b < a ? b : a; }},
    {"max", [](double a, double b) { return a < b ? b : a; }},
    {"sum", [](double a, double b) { return a + b; }},
    {"avg", [](double a, double b) { return a + b; }},
});

constexpr auto constants = std::to_array<Named<double>>({
    {"pi", std::numbers::pi},
    {"_pi", std::numbers::pi},
    {"e", std::numbers::e},
    {"_e", std::numbers::e},
});

constexpr auto comparisons = std::to_array<Named<OfTwo>>({
    {"<=", [](double a, double b) { return double(a <= b); }},
    {">=", [](double a, double b) { return double(a >= b); }},
    {"==", [](double a, double b) { return double(a == b); }},
    {"!=", [](double a, double b) { return double(a != b); }},
    {"<", [](double a, double b) { return double(a < b); }},
    {">", [](double a, double b) { return double(a > b); }},
});

constexpr auto sums = std::to_array<Named<OfTwo>>({
    {"+", [](double a, double b) { return a + b; }},
    {"-", [](double a, double b) { return a - b; }},
});

constexpr auto products = std::to_array<Named<OfTwo>>({
    {"*", [](double a, double b) { return a * b; }},
    {"/", [](double a, double b) { return a / b; }},
});

template <class Table>
auto find_named(const Table& table, std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& each) { return each.name == name; });
    return found == table.end() ? std::nullopt : std::optional(found->value);
}

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }

HeightFunction applied(auto of, HeightFunction a) {
    return [of, a = std::move(a)](double x, double z) { return of(a(x, z)); };
}

HeightFunction applied(auto of, HeightFunction a, HeightFunction b) {
    return [of, a = std::move(a), b = std::move(b)](double x, double z) { return of(a(x, z), b(x, z)); };
}

/// Each function reads what its name says from the rest of the text and returns it as a function of x and z.
class FormulaReader {
public:
    explicit FormulaReader(std::string_view text) : rest_(text) {}

    HeightFunction whole() {
        if (rest_.size() > most_characters)
            throw Refused("longer than " + std::to_string(most_characters) + " characters");
        if (next() == '\0') throw Refused("it is empty");
        HeightFunction read = conditional();
        if (next() != '\0') refuse_next();
        return read;
    }

private:
    HeightFunction conditional() {
        HeightFunction condition = disjunction();
        if (!take("?")) return condition;
        HeightFunction then = conditional();
        if (!take(":")) refuse_next();
        HeightFunction otherwise = conditional();
        return [=](double x, double z) { return condition(x, z) != 0 ? then(x, z) : otherwise(x, z); };
    }

    HeightFunction disjunction() {
        HeightFunction left = conjunction();
        while (take("||")) {
            left = [=, right = conjunction()](double x, double z) {
                return double(left(x, z) != 0 || right(x, z) != 0);
            };
        }
        return left;
    }

    HeightFunction conjunction() {
        HeightFunction left = comparison();
        while (take("&&")) {
            left = [=, right = comparison()](double x, double z) {
                return double(left(x, z) != 0 && right(x, z) != 0);
            };
        }
        return left;
    }

    HeightFunction comparison() {
        HeightFunction left = sum();
        const auto of = take_one_of(comparisons);
        if (!of) return left;
        HeightFunction compared = applied(*of, std::move(left), sum());
        if (take_one_of(comparisons)) throw Refused("a comparison has two sides; && joins two comparisons");
        return compared;
    }

    HeightFunction sum() {
        HeightFunction left = product();
        while (const auto of = take_one_of(sums)) left = applied(*of, std::move(left), product());
        return left;
    }

    HeightFunction product() {
        HeightFunction left = signed_power();
        while (const auto of = take_one_of(products)) left = applied(*of, std::move(left), signed_power());
        return left;
    }

    /// The power comes before the sign: -x^2 is -(x^2).
    HeightFunction signed_power() {
        if (take("-")) return applied(std::negate<>(), signed_power());
        return take("+") ? signed_power() : power();
    }

    /// Powers are read from the right: x^y^z is x^(y^z).
    HeightFunction power() {
        HeightFunction base = operand();
        if (!take("**") && !take("^")) return base;
        return applied(elementary::pow, std::move(base), signed_power());
    }

    HeightFunction operand() {
        HeightFunction read;
        if (is_digit(next()) || next() == '.') {
            read = [value = number()](double, double) { return value; };
        } else if (is_letter(next())) {
            read = named();
        } else if (take("(")) {
            read = conditional();
            if (!take(")")) refuse_next();
        } else {
            refuse_next();
        }
        if (is_letter(next()) || is_digit(next()) || next() == '(') throw Refused("a product is written with *");
        return read;
    }

    double number() {
        double value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        const auto size = std::max<std::size_t>(1, std::size_t(end - rest_.data()));
        const std::string text(rest_.substr(0, size));
        rest_.remove_prefix(size);
        if (error == std::errc::result_out_of_range) throw Refused(text + ": beyond the range of double");
        if (error != std::errc{} || next() == '.') throw Refused(text + (next() == '.' ? "." : "") + ": no number");
        return value;
    }

    HeightFunction named() {
        const auto end =
            std::find_if_not(rest_.begin(), rest_.end(), [](char c) { return is_letter(c) || is_digit(c); });
        const std::string_view name = rest_.substr(0, std::size_t(end - rest_.begin()));
        rest_.remove_prefix(name.size());
        if (name == "x") return [](double x, double) { return x; };
        if (name == "z") return [](double, double z) { return z; };
        if (const auto value = find_named(constants, name)) return [value](double, double) { return *value; };
        if (const auto of = find_named(functions_of_one, name)) return applied(*of, arguments(name, 1).front());
        if (const auto of = find_named(functions_of_two, name)) {
            const auto given = arguments(name, 2);
            return applied(*of, given.front(), given.back());
        }
        if (const auto of = find_named(functions_of_many, name)) return of_many(*of, name);
        const std::string unknown(name);
        if (next() == '(') throw Refused(unknown + ": no such function");
        if (name == "y") throw Refused("y: the formula gives its value; there are x, z, pi and e");
        throw Refused(unknown + ": not known; there are x, z, pi and e");
    }

    HeightFunction of_many(OfTwo of, std::string_view name) {
        const auto given = arguments(name, std::nullopt);
        HeightFunction all = given.front();
        for (std::size_t i = 1; i < given.size(); ++i) all = applied(of, std::move(all), given[i]);
        if (name != "avg") return all;
        return applied([count = double(given.size())](double sum) { return sum / count; }, std::move(all));
    }

    /// The arguments of a function, in parentheses.
    std::vector<HeightFunction> arguments(std::string_view function, std::optional<std::size_t> count) {
        const std::string name(function);
        if (!take("(")) throw Refused(name + ": takes its argument in parentheses");
        std::vector<HeightFunction> read;
        if (next() != ')') {
            do read.push_back(conditional());
            while (take(","));
        }
        if (!take(")")) refuse_next();
        if (!count ? read.empty() : read.size() != *count) {
            const char* const right = !count ? "one argument or more" : *count == 1 ? "one argument" : "two arguments";
            const bool is_perhaps_decimal = count && read.size() > *count;
            throw Refused(name + ": takes " + right + (is_perhaps_decimal ? "; a decimal fraction has a point" : ""));
        }
        return read;
    }

    /// The next character; '\0' at the end.
    char next() {
        while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
        return rest_.empty() ? '\0' : rest_.front();
    }

    bool take(std::string_view sign) {
        next();
        if (!rest_.starts_with(sign)) return false;
        rest_.remove_prefix(sign.size());
        return true;
    }

    /// The function of the sign that comes next, if it is one of the table. `**` is not a product.
    template <class Table>
    std::optional<OfTwo> take_one_of(const Table& table) {
        next();
        if (rest_.starts_with("**")) return std::nullopt;
        for (const auto& [sign, of] : table) {
            if (take(sign)) return of;
        }
        return std::nullopt;
    }

    [[noreturn]] void refuse_next() {
        switch (next()) {
            case '\0': throw Refused("it ends too early");
            case ',': throw Refused("a comma is only between arguments; a decimal fraction has a point");
            case '=': throw Refused("equality is written ==");
            case '|': throw Refused("an absolute value is written abs(x)");
            default: break;
        }
        const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
        const auto end = std::find_if_not(rest_.begin() + 1, rest_.end(), continues);
        throw Refused(std::string(rest_.begin(), end) + ": not understood");
    }

    std::string_view rest_;
};

}  // namespace

HeightFunction height_function(std::string_view text) { return FormulaReader(text).whole(); }

}  // namespace vidno
