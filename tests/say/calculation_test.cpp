// Calculations by hand, line by line; the numbers are worked out in the comments.

#include <doctest/doctest.h>

#include "say/decision.h"

using namespace vidno;
using namespace vidno::say;

namespace {

using Lines = std::vector<std::string>;

Operand given(const std::string& name, const std::string& number) { return {name, {number}, {number}}; }

/// The lines of the only calculation.
Lines lines_of(Decision of, const Operands& operands, Language language = Language::english,
               const std::string& other = "z₀") {
    const auto made = calculations(of, operands, language, other);
    REQUIRE(made.size() == 1);
    return made[0].lines;
}

std::string last_line(Decision of, const Operands& operands) { return lines_of(of, operands).back(); }

}  // namespace

TEST_CASE("a cross product is calculated line by line") {
    // (4 − 0)(2 − 0) − (0 − 0)(1 − 0) = 8.
    const Operands operands{given("pivot.x", "0/1"), given("pivot.y", "0/1"), given("a.x", "4/1"),
                            given("a.y", "0/1"),     given("b.x", "1/1"),     given("b.y", "2/1")};
    CHECK(lines_of(Decision::orientation, operands) ==
          Lines{"f = (aₓ − oₓ) (bᵧ − oᵧ) − (aᵧ − oᵧ) (bₓ − oₓ)", "= 4 · 2 − 0 · 1", "= 8 − 0", "= 8 > 0"});
}

TEST_CASE("a negative number and a fraction stand in brackets beside an operator") {
    // −1 (1/2 − 0) + 2 (0 − 1) = −1/2 − 2 = −5/2, in the line's own signs.
    const Operands operands{given("line.a", "-1/1"), given("line.b", "2/1"), given("line.x", "0/1"),
                            given("line.y", "1/1"),  given("p.x", "1/2"),    given("p.y", "0/1")};
    CHECK(lines_of(Decision::orientation, operands) ==
          Lines{"f = a (pₓ − x) + b (pᵧ − y)", "= (−1) · (1/2) + 2 · (−1)", "= −1/2 + (−2)", "= −5/2 < 0"});
    CHECK(last_line(Decision::left_of, operands) == "a < 0");
}

TEST_CASE("if the operands had drifted, the run's numbers have a calculation, too") {
    const Operands operands{{"z", {"1/2"}, {"1/3"}}, given("against", "2/5")};
    const auto made = calculations(Decision::nearer, operands, Language::english);
    REQUIRE(made.size() == 2);
    CHECK(made[0].title == "Step by step with the numbers of this run");
    CHECK(made[0].lines.back() == "z > z₀");
    CHECK(made[1].title == "Step by step with the exact numbers");
    // 1/3 − 2/5 = 5/15 − 6/15.
    CHECK(made[1].lines == Lines{"z = 1/3", "z₀ = 2/5", "z − z₀ = −1/15 < 0", "z < z₀"});
}

TEST_CASE("the first and the last pixel centre stay within their range") {
    // The centres are 2.5, 3.5, and so on. The first one at or after 5/2 is that of column 2; the last one up to 7/3 is
    // that of column 1.
    const auto at = [](const char* x) { return Operands{given("x", x), given("low", "0/1"), given("end", "4/1")}; };
    CHECK(last_line(Decision::first_centre, at("5/2")) == "i + 1/2 ≥ 5/2 ⇒ i = ⌈2⌉ = 2");
    CHECK(last_line(Decision::last_centre, at("7/3")) == "i + 1/2 ≤ 7/3 ⇒ i = ⌊11/6⌋ = 1");
    // Outside the range, 9 is limited to its end, and −3 to one before its beginning.
    CHECK(last_line(Decision::first_centre, at("19/2")) == "i + 1/2 ≥ 19/2 ⇒ i = ⌈9⌉ = 9 → 4");
    CHECK(last_line(Decision::last_centre, at("-5/2")) == "i + 1/2 ≤ −5/2 ⇒ i = ⌊−3⌋ = −3 → −1");
}

TEST_CASE("where an outline meets a row is calculated edge by edge") {
    // Row 1 has the centre line y = 3/2. From (0, 0) to (4, 2): x = 0 + 3/2 · 4 / 2 = 3; back from (4, 2) to (0, 4) it
    // does not come, for both are below; from (0, 4) to (0, 0): x = 0 + (−5/2) · 0 / (−4) = 0.
    Operands operands{given("v0.x", "0/1"), given("v0.y", "0/1"), given("v1.x", "4/1"),
                      given("v1.y", "2/1"), given("v2.x", "0/1"), given("v2.y", "4/1"),
                      given("row", "1/1"),  given("low", "0/1"),  given("end", "4/1")};
    CHECK(lines_of(Decision::columns, operands) ==
          Lines{"y = 3/2", "v0 v1: x = 0 + (3/2) · 4 / 2 = 3", "v2 v0: x = 0 + (−5/2) · 0 / (−4) = 0", "min x = 0",
                "i + 1/2 ≥ 0 ⇒ i = ⌈−1/2⌉ = 0", "max x = 3", "i + 1/2 ≤ 3 ⇒ i = ⌊5/2⌋ = 2"});
    CHECK(lines_of(Decision::rows, operands) ==
          Lines{"min y = 0", "i + 1/2 ≥ 0 ⇒ i = ⌈−1/2⌉ = 0", "max y = 4", "i + 1/2 ≤ 4 ⇒ i = ⌊7/2⌋ = 3"});
}

TEST_CASE("numbers round as the printed text rounds them") {
    // ⌊2.5 + 0.5⌋ = 3, ⌊2.25 + 0.5⌋ = 2; ⌊−1/2⌋ = −1.
    CHECK(lines_of(Decision::same_rounded, {given("v", "5/2"), given("w", "9/4")}) ==
          Lines{"⌊v + 1/2⌋ = ⌊3⌋ = 3", "⌊w + 1/2⌋ = ⌊11/4⌋ = 2"});
    CHECK(lines_of(Decision::pixel, {given("v", "-1/2")}) == Lines{"⌊v⌋ = ⌊−1/2⌋ = −1"});
}

TEST_CASE("two planes are compared by their slopes, two lines by a cross product") {
    // q.a / q.c = 2/4, p.a / p.c = 1/2; q.b / q.c = 0, p.b / p.c = 3/2.
    CHECK(lines_of(Decision::parallel, {given("p.a", "1/1"), given("p.b", "3/1"), given("p.c", "2/1"),
                                        given("q.a", "2/1"), given("q.b", "0/1"), given("q.c", "4/1")}) ==
          Lines{"q.a / q.c − p.a / p.c = 1/2 − (1/2) = 0", "q.b / q.c − p.b / p.c = 0 − (3/2) = −3/2 < 0"});
    CHECK(last_line(Decision::parallel,
                    {given("p.a", "1/1"), given("p.b", "2/1"), given("q.a", "2/1"), given("q.b", "4/1")}) == "= 0");
}

TEST_CASE("without numbers there is no calculation") {
    const Operands undefined{{"z", {"nan"}, {"1/2"}}, {"against", {"0/1"}, {""}}};
    for (const auto& made : calculations(Decision::nearer, undefined, Language::english)) {
        CHECK(made.lines == Lines{"One of the numbers is undefined or infinite."});
    }
    const Operands first{given("z", "1/2"), given("against", "-inf")};
    CHECK(lines_of(Decision::nearer, first, Language::russian) == Lines{"Одно из чисел не определено или бесконечно."});
}

TEST_CASE("operands have the symbols of the listings, and horizons are words of the language") {
    CHECK(lines_of(Decision::nearer, {given("z", "1/3"), given("against", "2/5")}, Language::english, "Z")[3] ==
          "z < Z");
    CHECK(lines_of(Decision::columns, {given("left", "1/1"), given("right", "2/1"), given("low", "0/1"),
                                       given("end", "4/1")})[0] == "x₁ = 1");
    const Operands heights{given("y", "1/1"), given("upper", "2/1")};
    CHECK(lines_of(Decision::visibility, heights)[3] == "y < upper");
    CHECK(lines_of(Decision::visibility, heights, Language::russian)[3] == "y < верхний");
}
