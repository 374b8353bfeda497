// Numbers of a sentence: short, and no more alike than they are.

#include "say/numbers.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace vidno;
using namespace vidno::say;

namespace {

std::string english(const Value& value) { return short_number(value, Language::english); }
std::string russian(const Value& value) { return short_number(value, Language::russian); }
Value fraction(const char* text) { return Value(std::string(text)); }

using Pair = std::pair<std::string, std::string>;

}  // namespace

TEST_CASE("numbers are short, with a real minus sign, and marked where digits are missing") {
    CHECK(english(0.5) == "0.5");
    CHECK(english(-2.) == "−2");
    CHECK(english(-0.) == "0");
    CHECK(english(0.1 + 0.2) == "≈0.3");
    CHECK(english(1 / 3.) == "≈0.3333");
    CHECK(english(1e-9 / 3) == "≈3.33e−10");
    CHECK(english(-1e-9) == "−1e−9");
    CHECK_MESSAGE(english(-0.0390625) == "≈−0.039", "with its sign it has room for seven characters");
    CHECK(english(1234567.) == "1234567");
    CHECK(english(1.25e9) == "1.25e+9");
    CHECK_MESSAGE(english(11250000.) == "≈1.13e+7", "halves are rounded up");
    CHECK(english(-123456.7) == "≈−1.2e+5");
    CHECK(english(0.00012345) == "≈0.00012");
}

TEST_CASE("numbers that are none have their names") {
    CHECK(english(Value::minus_infinite()) == "−∞");
    CHECK(english(Value::infinite()) == "∞");
    CHECK(english(std::nan("")) == "nan");
    CHECK(english(fraction("nan")) == "nan");
    CHECK(english(fraction("1/0")) == "1/0");
}

TEST_CASE("fractions are written as such if they are short") {
    CHECK(english(fraction("1/10")) == "1/10");
    CHECK(english(fraction("-3/1")) == "−3");
    CHECK(english(fraction("-1000000000000000000001/3000000000000000000000")) == "≈−0.333");
}

TEST_CASE("Russian numbers have a decimal comma") {
    CHECK(russian(-2.667) == "−2,667");
    CHECK(russian(1 / 3.) == "≈0,3333");
    CHECK(in_full(-0.05859375372529, Language::russian) == "−0,05859375372529");
}

TEST_CASE("numbers that are compared are short if that distinguishes them, or else in full") {
    const auto compared = [](const Value& one, const Value& other) { return apart(one, other, Language::english); };
    CHECK(compared(0.5, 0.25) == Pair("0.5", "0.25"));
    CHECK(compared(-0.0585937462747097, -0.05859375) == Pair("−0.0585937462747097", "−0.05859375"));
    CHECK(compared(0.123456789, 0.123456789) == Pair("≈0.1235", "≈0.1235"));
    CHECK(compared(fraction("1234567/7654321"), fraction("1234568/7654321")) ==
          Pair("1234567/7654321", "1234568/7654321"));
    const std::string ones(50, '1');
    const auto [one, other] = compared(Value(ones + "1/" + ones + "3"), Value(ones + "2/" + ones + "3"));
    CHECK_MESSAGE(one.size() + other.size() < 40, "never longer than a sentence");
}

TEST_CASE("a whole number as a summand has its sign") {
    CHECK(signed_number(2) == "+2");
    CHECK(signed_number(0) == "0");
    CHECK(signed_number(-2) == "−2");
}

TEST_CASE("numbers are ordered exactly, whatever they are written as") {
    CHECK(order_of(0.5, 0.25) == Sign::positive);
    CHECK(order_of(0.5, 0.5) == Sign::zero);
    CHECK(order_of(Value::minus_infinite(), -3.) == Sign::negative);
    CHECK(order_of(Value::minus_infinite(), Value::minus_infinite()) == Sign::zero);
    CHECK(order_of(std::nan(""), 0.) == std::nullopt);
    CHECK(order_of(fraction("1/3"), fraction("333333333333333333333/1000000000000000000000")) == Sign::positive);
    CHECK(order_of(fraction("-1/2"), fraction("-2/4")) == Sign::zero);
    CHECK(order_of(fraction("-1/2"), fraction("1/100")) == Sign::negative);
    CHECK(order_of(fraction("1/2"), Value::infinite()) == Sign::negative);
}
