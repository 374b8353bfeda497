// Included before everything else. Without GMP, CGAL's rationals are quotients of Boost's integers, and CGAL splits a
// double into two doubles: below 2^-1023 the denominator would be infinite.
#pragma once

#include <CGAL/boost_mp.h>

#include <cmath>
#include <cstdint>

template <>
struct CGAL::Split_double<boost::multiprecision::cpp_int> {
    using Integer = boost::multiprecision::cpp_int;

    void operator()(double value, Integer& numerator, Integer& denominator) const {
        int exponent = 0;
        auto significand = std::int64_t(std::ldexp(std::frexp(value, &exponent), 53));
        exponent -= 53;
        const int zeros = significand == 0 ? 0 : __builtin_ctzll(std::uint64_t(significand));
        significand >>= zeros;
        exponent = significand == 0 ? 0 : exponent + zeros;
        numerator = significand;
        denominator = 1;
        (exponent < 0 ? denominator : numerator) <<= std::abs(exponent);
    }
};
