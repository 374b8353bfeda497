#include "run/exact_number.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>

using vidno::ExactNumber;
using vidno::Rational;

namespace {

/// A double of any size, often with few digits, so that some results need no rounding.
double any_double(std::mt19937& random) {
    const int digits = std::uniform_int_distribution(1, 53)(random);
    const auto significand = double(std::uniform_int_distribution<std::int64_t>(-(1LL << 53), 1LL << 53)(random));
    const bool is_extreme = random() % 4 == 0;
    const int exponent = is_extreme ? std::uniform_int_distribution(-1070, 900)(random) : int(random() % 40) - 20;
    return std::ldexp(std::trunc(std::ldexp(significand, digits - 53)), exponent);
}

std::string text(const Rational& value) { return vidno::Exact::fraction(value); }

/// Compares a result, and its double if it has one, with that of rationals.
void check_result(double a, double b, auto operation) {
    const Rational right = operation(Rational(a), Rational(b));
    const ExactNumber found = ExactNumber::result(ExactNumber(a), ExactNumber(b), operation);
    CHECK(found.fraction() == text(right));
    CHECK(text(found.rational()) == text(right));
    CHECK(int(found.sign()) == int(CGAL::sign(right)));
    if (const auto kept = found.as_double()) CHECK(Rational(*kept) == right);
}

bool needs_no_rational(double a, double b, auto operation) {
    return ExactNumber::result(ExactNumber(a), ExactNumber(b), operation).as_double().has_value();
}

}  // namespace

TEST_CASE("Exact numbers: results of doubles of any size are those of rationals") {
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        const double a = any_double(random);
        const double b = any_double(random);
        CAPTURE(a);
        CAPTURE(b);
        check_result(a, b, std::plus<>());
        check_result(a, b, std::minus<>());
        check_result(a, b, std::multiplies<>());
        if (b != 0) check_result(a, b, std::divides<>());
        CHECK(ExactNumber::related(ExactNumber(a), ExactNumber(b), std::less<>()) == (a < b));
    }
}

TEST_CASE("Exact numbers: a result stays a double if it is one") {
    CHECK(needs_no_rational(0.5, 0.25, std::plus<>()));
    CHECK(needs_no_rational(1.5, 1.5, std::minus<>()));
    CHECK(needs_no_rational(0.75, 10.5, std::multiplies<>()));
    CHECK(needs_no_rational(6, 4, std::divides<>()));
    CHECK(needs_no_rational(0, 7, std::divides<>()));
}

TEST_CASE("Exact numbers: a result that was rounded, or may have been, is a rational") {
    CHECK_FALSE(needs_no_rational(0.1, 0.2, std::plus<>()));
    CHECK_FALSE(needs_no_rational(1, 3, std::divides<>()));
    CHECK_FALSE(needs_no_rational(0.1, 0.1, std::multiplies<>()));
    CHECK_FALSE(needs_no_rational(0x1p-600, 0x1p-600, std::multiplies<>()));  // 2^-1200 is no double
    CHECK_FALSE(needs_no_rational(0x1p1023, 0x1p1023, std::plus<>()));        // nor is 2^1024
    CHECK_FALSE(needs_no_rational(0x1p-537, 0x1p-537, std::multiplies<>()));  // 2^-1074 is the least double
}

TEST_CASE("Exact numbers: chains of results are those of rationals") {
    std::mt19937 random(2);
    for (int chain = 0; chain < 5000; ++chain) {
        ExactNumber found(double(int(random() % 200) - 100));
        Rational right = found.rational();
        for (int i = 0; i < 8; ++i) {
            const double number = random() % 8 == 0 ? any_double(random) : std::ldexp(int(random() % 100) - 50, -2);
            const ExactNumber operand(number);
            const auto apply = [&](auto operation) {
                found = ExactNumber::result(found, operand, operation);
                right = operation(right, Rational(number));
            };
            switch (random() % 4) {
                case 0: apply(std::plus<>()); break;
                case 1: apply(std::minus<>()); break;
                case 2: apply(std::multiplies<>()); break;
                default:
                    if (number != 0) apply(std::divides<>());
            }
            CHECK(found.fraction() == text(right));
            CHECK(text((-found).rational()) == text(-right));
            CHECK(int(found.sign()) == int(CGAL::sign(right)));
            CHECK(ExactNumber::related(found, operand, std::less<>()) == (right < Rational(number)));
            CHECK(double(found) == CGAL::to_double(right));
        }
    }
}

TEST_CASE("Exact numbers: quotients are compared and written exactly") {
    const ExactNumber third = ExactNumber::result(ExactNumber(1.0), ExactNumber(-3.0), std::divides<>());
    const ExactNumber one = ExactNumber::result(third, ExactNumber(-3.0), std::multiplies<>());
    CHECK(third.fraction() == "-1/3");
    CHECK((-third).fraction() == "1/3");
    CHECK(third.sign() == vidno::Sign::negative);
    CHECK(one.as_double() == 1);
    CHECK(ExactNumber::related(one, ExactNumber(1.0), std::equal_to<>()));
    CHECK(ExactNumber::related(-third, ExactNumber(1.0 / 3), std::greater<>()));  // the double is less than a third
    CHECK(ExactNumber::result(third, third, std::plus<>()).fraction() == "-2/3");
    CHECK(ExactNumber::result(ExactNumber(6.0), ExactNumber(0x1p70), std::divides<>()).fraction() ==
          "3/590295810358705651712");
}

TEST_CASE("Exact numbers: sums and comparisons of quotients are those of rationals") {
    std::mt19937 random(3);
    const auto quotient = [&](std::int64_t largest) {
        std::uniform_int_distribution<std::int64_t> whole(1, largest);
        const auto p = double(whole(random)), q = double(whole(random));
        const ExactNumber found = ExactNumber::result(ExactNumber(p), ExactNumber(q), std::divides<>());
        return std::pair(found, Rational(Rational(p) / Rational(q)));
    };
    for (const std::int64_t largest : {20LL, 1LL << 20, 1LL << 53}) {
        for (int i = 0; i < 3000; ++i) {
            auto [sum, right_sum] = quotient(largest);
            const auto [slope, right_slope] = quotient(largest);
            for (int step = 0; step < 4; ++step) {
                sum = ExactNumber::result(sum, slope, std::plus<>());
                right_sum = Rational(right_sum + right_slope);
            }
            CHECK(sum.fraction() == text(right_sum));
            CHECK(ExactNumber::related(sum, slope, std::greater<>()));
            const auto [other, right_other] = quotient(largest);
            CHECK(ExactNumber::related(sum, other, std::less<>()) == (right_sum < right_other));
        }
    }
}

TEST_CASE("Exact numbers: quotients that differ by less than a rounding are not equal") {
    // n / (n + 1) and (n + 1) / (n + 2): crosswise, n (n + 2) is one less than (n + 1)^2.
    for (const double n : {3.0, 0x1p26, 0x1p40, 0x1p52}) {
        const auto below_one = [](double p) {
            return ExactNumber::result(ExactNumber(p), ExactNumber(p + 1), std::divides<>());
        };
        CHECK(ExactNumber::related(below_one(n), below_one(n + 1), std::less<>()));
        CHECK_FALSE(ExactNumber::related(below_one(n), below_one(n + 1), std::equal_to<>()));
        CHECK(ExactNumber::related(below_one(n), below_one(n), std::equal_to<>()));
    }
}

TEST_CASE("Exact numbers: the whole part is the greatest whole number that is not above") {
    const auto whole_part_of = [](double p, double q) {
        return ExactNumber::result(ExactNumber(p), ExactNumber(q), std::divides<>()).whole_part(-8, 8);
    };
    CHECK(whole_part_of(7, 2) == 3);
    CHECK(whole_part_of(-7, 2) == -4);
    CHECK(whole_part_of(6, 2) == 3);
    CHECK(whole_part_of(1, 3) == 0);
    CHECK(whole_part_of(-1, 3) == -1);
    CHECK(whole_part_of(-8, 1) == -8);
    CHECK(whole_part_of(0x1p53 * 3 - 4, 0x1p53) == 2);    // 3 - 2^-51
    CHECK(whole_part_of(-0x1p53 * 3 + 4, 0x1p53) == -3);  // -3 + 2^-51
    const ExactNumber third = ExactNumber::result(ExactNumber(1.0), ExactNumber(3.0), std::divides<>());
    const ExactNumber hardly_less = ExactNumber::result(third, ExactNumber(0x1p-80), std::minus<>());
    const ExactNumber thrice = ExactNumber::result(hardly_less, ExactNumber(3.0), std::multiplies<>());
    CHECK(thrice.whole_part(-8, 8) == 0);  // 1 - 3 * 2^-80, whose nearest double is 1
}

TEST_CASE("Exact numbers: fractions of doubles") {
    CHECK(ExactNumber(0.0).fraction() == "0/1");
    CHECK(ExactNumber(-0.0).fraction() == "0/1");
    CHECK_FALSE(std::signbit(double(ExactNumber(-0.0))));
    CHECK(ExactNumber(-2.75).fraction() == "-11/4");
    CHECK(ExactNumber(0x1p62).fraction() == "4611686018427387904/1");
    CHECK(ExactNumber(0x1p63).fraction() == "9223372036854775808/1");
    CHECK(ExactNumber(0x1p-62).fraction() == "1/4611686018427387904");
    CHECK(ExactNumber(0x1p-63).fraction() == "1/9223372036854775808");
    CHECK_FALSE(ExactNumber());
}
