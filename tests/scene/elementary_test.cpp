// The functions of formulas, rounded once on every machine.

#include "scene/elementary.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace elementary = vidno::elementary;

TEST_CASE("Elementary functions are rounded once") {
    // More digits than a double has; the compiler rounds them to the nearest one.
    CHECK(elementary::sin(1) == 0.841470984807896506652502321630);
    CHECK(elementary::cos(1) == 0.540302305868139717400936607443);
    CHECK(elementary::exp(1) == 2.718281828459045235360287471353);
    CHECK(elementary::log(2) == 0.693147180559945309417232121458);
    CHECK(elementary::atan2(1, 1) == 0.785398163397448309615660845820);
    // The cube of the double 0.3 is 0.0269999999999999970024...; two products of doubles give the next double above.
    CHECK(elementary::pow(0.3, 3) == 0x1.ba5e353f7ced8p-6);
    CHECK(0.3 * 0.3 * 0.3 == 0x1.ba5e353f7ced9p-6);
}

TEST_CASE("Elementary functions have the usual values where there is no other number") {
    CHECK(std::isnan(elementary::log(-1)));
    CHECK(elementary::exp(1000) == std::numeric_limits<double>::infinity());
    CHECK(elementary::pow(0, 0) == 1);
    CHECK(elementary::sin(0) == 0);
}
