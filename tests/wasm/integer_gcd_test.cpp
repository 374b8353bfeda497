#include "wasm/integer_gcd.h"

#include <gmp.h>

#include <doctest/doctest.h>

#include <random>
#include <string>

namespace vidno {
namespace {

using Integer = boost::multiprecision::cpp_int;

Integer computed_gcd(const Integer& a, const Integer& b) {
    Integer divisor;
    eval_gcd(divisor.backend(), a.backend(), b.backend());
    return divisor;
}

/// What GMP computes.
Integer reference_gcd(const Integer& a, const Integer& b) {
    mpz_t left, right;
    mpz_init_set_str(left, a.str().c_str(), 10);
    mpz_init_set_str(right, b.str().c_str(), 10);
    mpz_gcd(left, left, right);
    std::string digits(mpz_sizeinbase(left, 10) + 2, '\0');
    mpz_get_str(digits.data(), 10, left);
    mpz_clears(left, right, nullptr);
    return Integer(digits.c_str());
}

struct RandomIntegers {
    std::mt19937_64 random{1};

    /// With at most this number of bits, and in half of the cases negative.
    Integer operator()(unsigned most_bits) {
        Integer value = 0;
        for (unsigned bits = 0; bits < most_bits; bits += 64) value = (value << 64) | random();
        value >>= random() % (most_bits + 64);
        return random() % 2 == 0 ? value : Integer(-value);
    }
};

TEST_CASE("The greatest common divisor is GMP's for random integers with a common factor") {
    RandomIntegers random;
    for (int i = 0; i < 20'000; ++i) {
        const Integer factor = random(128), a = random(384) * factor, b = random(384) * factor;
        CAPTURE(a);
        CAPTURE(b);
        REQUIRE(computed_gcd(a, b) == reference_gcd(a, b));
    }
}

TEST_CASE("The greatest common divisor is GMP's for integers that differ by a few or by a power of two") {
    RandomIntegers random;
    for (int i = 0; i < 5'000; ++i) {
        const Integer a = random(320), near = a + i % 7 - 3, shifted = abs(a) << (i % 200),
                      power = Integer(1) << (i % 300);
        CAPTURE(a);
        REQUIRE(computed_gcd(a, near) == reference_gcd(a, near));
        REQUIRE(computed_gcd(a, shifted) == reference_gcd(a, shifted));
        REQUIRE(computed_gcd(a, power) == reference_gcd(a, power));
    }
}

TEST_CASE("Euclid's longest way: neighbours among Fibonacci's numbers have no common divisor") {
    Integer last = 1, next = 1;
    for (int i = 0; i < 600; ++i) {
        next += last;
        last.swap(next);
        CHECK(computed_gcd(last, next) == 1);
        CHECK(computed_gcd(last * 360, next * 360) == 360);
    }
}

TEST_CASE("The greatest common divisor of an integer and 0 is the integer, without its sign") {
    const Integer large = Integer(3) << 200;
    CHECK(computed_gcd(large, 0) == large);
    CHECK(computed_gcd(0, -large) == large);
    CHECK(computed_gcd(0, 0) == 0);
}

}  // namespace
}  // namespace vidno
