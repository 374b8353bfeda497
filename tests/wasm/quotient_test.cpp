#include "wasm/quotient.h"

#include <gmpxx.h>

#include <doctest/doctest.h>

#include <random>
#include <string>

namespace vidno {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Quotient = CGAL::Quotient<Integer>;

/// "p/q", q > 0, with the terms that the quotient has.
std::string text(const Quotient& value) {
    const int sign = value.den < 0 ? -1 : 1;
    return Integer(sign * value.num).str() + "/" + Integer(sign * value.den).str();
}
/// GMP keeps its rationals in lowest terms.
std::string text(const mpq_class& value) { return value.get_num().get_str() + "/" + value.get_den().get_str(); }

mpq_class by_gmp(const Quotient& value) { return mpq_class(text(value)); }

/// Quotients in lowest terms. Some are whole or 0, and many denominators have common factors.
struct RandomQuotients {
    std::mt19937_64 random{1};

    Integer integer(unsigned most_bits) {
        Integer value = 0;
        for (unsigned bits = 0; bits < most_bits; bits += 64) value = (value << 64) | random();
        return value >> (random() % (most_bits + 64));
    }
    Quotient operator()() {
        Integer p = integer(256), q = (integer(256) + 1) << (random() % 60);
        if (random() % 3 == 0) q *= 360;
        if (random() % 5 == 0) q = 1;
        const Integer divisor = boost::multiprecision::gcd(p, q);
        p /= divisor;
        q /= divisor;
        return {random() % 2 == 0 ? p : Integer(-p), q};
    }
};

TEST_CASE("Sums, differences, products and quotients of random rationals are GMP's, in lowest terms") {
    RandomQuotients random;
    for (int i = 0; i < 5'000; ++i) {
        const Quotient a = random(), b = random();
        CAPTURE(text(a));
        CAPTURE(text(b));
        REQUIRE(text(a + b) == text(mpq_class(by_gmp(a) + by_gmp(b))));
        REQUIRE(text(a - b) == text(mpq_class(by_gmp(a) - by_gmp(b))));
        REQUIRE(text(a * b) == text(mpq_class(by_gmp(a) * by_gmp(b))));
        if (b != 0) REQUIRE(text(a / b) == text(mpq_class(by_gmp(a) / by_gmp(b))));
    }
}

TEST_CASE("A rational may be combined with itself: 2/3 gives 4/3, 0, 4/9 and 1") {
    const Quotient two_thirds(Integer(2), Integer(3));
    Quotient sum = two_thirds, difference = two_thirds, product = two_thirds, quotient = two_thirds;
    const auto itself = [](const Quotient& operand) -> const Quotient& { return operand; };
    sum += itself(sum);
    difference -= itself(difference);
    product *= itself(product);
    quotient /= itself(quotient);
    CHECK(text(sum) == "4/3");
    CHECK(text(difference) == "0/1");
    CHECK(text(product) == "4/9");
    CHECK(text(quotient) == "1/1");
}

}  // namespace
}  // namespace vidno
