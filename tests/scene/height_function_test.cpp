// Formulas: what they mean, and what is said of a text that is none.

#include "scene/height_function.h"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "refused.h"

using vidno::height_function;

namespace {

struct Valued {
    const char* formula;
    double x, z, value;
};

struct RefusedText {
    std::string text, reason;
};

std::string reason_against(const std::string& text) {
    try {
        height_function(text);
    } catch (const vidno::Refused& refused) {
        return refused.what();
    }
    return "taken";
}

}  // namespace

TEST_CASE("Formulas: values") {
    for (const auto& [formula, x, z, value] : std::vector<Valued>{
             {"x - z * 2", 2, 3, -4},
             {"-x^2", 2, 0, -4},
             {"2^x^z", 2, 3, 256},
             {"2**x**z", 2, 3, 256},
             {"2^-1", 0, 0, 0.5},
             {"x*-z", 2, 3, -6},
             {"6 / 3 / 2 - 1 - 1", 0, 0, -1},
             {"+x", 2, 0, 2},
             {"x < z ? 10 : 20", 2, 3, 10},
             {"x > z ? 1 : x == 2 ? 5 : 6", 2, 3, 5},
             {"x + z * 2 < 9 && x > 1 ? x - z / 2 : 0", 2, 3, 0.5},
             {"x > 9 || z == 3", 2, 3, 1},
             {"(x < z) * 5", 2, 3, 5},
             {"1e3 + .5 + 5.", 0, 0, 1005.5},
             {"max(x, z, 7) + min(x, z) + sum(1, 2) + avg(2, 4)", 2, 3, 15},
             {"abs(-x) + sqrt(16) + atan2(0, 1) + sign(z) + sign(-z) + sign(0)", 2, 3, 6},
             {"floor(x) + ceil(x) + rint(x)", 2.5, 0, 8},
             {"pow(x, 3)", 2, 0, 8},
             {"e - _e + pi - _pi", 0, 0, 0},
             {"x^3", 0.3, 0, 0x1.ba5e353f7ced8p-6},  // rounded once, as in elementary_test.cpp
             {"ln(x)", 2, 0, 0.693147180559945309417232121458},
             {"x == 1 ? 1 : 0", 1 + 0x1p-52, 0, 0},
         }) {
        const auto& shown_formula = formula;
        CAPTURE(shown_formula);
        CHECK(height_function(formula)(x, z) == value);
    }
}

TEST_CASE("Formulas: a text that is none is refused with what to write instead") {
    const std::string decimal = "; a decimal fraction has a point";
    const std::string comma = "a comma is only between arguments" + decimal;
    const std::string names = "; there are x, z, pi and e";
    for (const auto& [text, reason] : std::vector<RefusedText>{
             {"0,5*x", comma},
             {"x * 0,5", comma},
             {"(0,5) * x", comma},
             {"sin(x), cos(z)", comma},
             {"sin(0,5*x)", "sin: takes one argument" + decimal},
             {"atan2(0,5*x, z)", "atan2: takes two arguments" + decimal},
             {"atan2(x)", "atan2: takes two arguments"},
             {"sin()", "sin: takes one argument"},
             {"min()", "min: takes one argument or more"},
             {"sin x", "sin: takes its argument in parentheses"},
             {"sin^2(x)", "sin: takes its argument in parentheses"},
             {"2x", "a product is written with *"},
             {"2(x + z)", "a product is written with *"},
             {"x(z)", "a product is written with *"},
             {"(x)(z)", "a product is written with *"},
             {"x z", "a product is written with *"},
             {"xz", "xz: not known" + names},
             {"x + y", "y: the formula gives its value" + names},
             {"r", "r: not known" + names},
             {"cot(x)", "cot: no such function"},
             {"|x|", "an absolute value is written abs(x)"},
             {"2*|x|", "an absolute value is written abs(x)"},
             {"y = x", "y: the formula gives its value" + names},
             {"x = 3", "equality is written =="},
             {"x < z < 4", "a comparison has two sides; && joins two comparisons"},
             {"x == z == 1", "a comparison has two sides; && joins two comparisons"},
             {"", "it is empty"},
             {" \t", "it is empty"},
             {"x +", "it ends too early"},
             {"(x", "it ends too early"},
             {"x ? 1", "it ends too early"},
             {"x + ) + z", "): not understood"},
             {"x ! z", "!: not understood"},
             {"x % 2", "%: not understood"},
             {"x\xC2\xB2", "\xC2\xB2: not understood"},
             {"1.2.3", "1.2.: no number"},
             {"1..2", "1..: no number"},
             {".", ".: no number"},
             {"1e999", "1e999: beyond the range of double"},
             {std::string(1001, ' '), "longer than 1000 characters"},
         }) {
        const auto& shown_text = text;
        CAPTURE(shown_text);
        CHECK(reason_against(text) == reason);
    }
}

TEST_CASE("Formulas: the longest and deepest are read") {
    std::string deep = "x", sum = "x";
    while (deep.size() + 2 <= 1000) deep = "(" + deep + ")";
    while (sum.size() + 2 <= 1000) sum += "+x";
    CHECK(height_function(deep)(3, 0) == 3);
    CHECK(height_function(sum)(1, 0) == 500);
    CHECK(height_function(std::string(999, '-') + "x")(1, 0) == -1);
}

TEST_CASE("Formulas: any text is read or refused") {
    const std::string characters = "xz019.e+-*/^()<>=!&|?:, sincopmax";
    std::mt19937 random(1);
    int read = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        for (auto left = random() % 12 + 1; left > 0; --left) text += characters[random() % characters.size()];
        read += reason_against(text) == "taken";
    }
    CHECK_MESSAGE(read > 200, "texts that are formulas");
}
