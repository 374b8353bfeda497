// Included before everything else. Without GMP, CGAL's rationals are quotients of Boost's integers. CGAL computes each
// result and reduces it. Here, smaller integers are reduced before they are multiplied (Knuth, The Art of Computer
// Programming 2, 4.5.1). If the operands are in lowest terms, so is the result.
#pragma once

#include <CGAL/boost_mp.h>

#include <functional>
#include <utility>

namespace CGAL {

namespace reduced {

using Integer = boost::multiprecision::cpp_int;
using boost::multiprecision::gcd;

/// The integer divided by one of its divisors.
inline Integer divided(const Integer& value, const Integer& divisor) {
    return divisor == 1 ? value : Integer(value / divisor);
}
/// (p / divisor_of_p) * (q / divisor_of_q)
inline Integer product(const Integer& p, const Integer& divisor_of_p, const Integer& q, const Integer& divisor_of_q) {
    if (divisor_of_p == 1 && divisor_of_q == 1) return p * q;
    return divided(p, divisor_of_p) * divided(q, divisor_of_q);
}

/// Adds or subtracts the other quotient.
inline void add(Quotient<Integer>& to, const Quotient<Integer>& other, auto plus_or_minus) {
    const Integer common = gcd(to.den, other.den);
    if (common == 1) {
        to.num = plus_or_minus(Integer(to.num * other.den), Integer(other.num * to.den));
        to.den *= other.den;
        return;
    }
    const Integer factor = to.den / common;
    const Integer sum = plus_or_minus(Integer(to.num * Integer(other.den / common)), Integer(other.num * factor));
    const Integer divisor = gcd(sum, common);
    to.den = factor * divided(other.den, divisor);
    to.num = divided(sum, divisor);
}

/// Multiplies by numerator / denominator.
inline void multiply(Quotient<Integer>& to, const Integer& numerator, const Integer& denominator) {
    const Integer in_first = gcd(to.num, denominator), in_second = gcd(numerator, to.den);
    Integer new_numerator = product(to.num, in_first, numerator, in_second);
    to.den = product(to.den, in_second, denominator, in_first);
    to.num = std::move(new_numerator);
}

}  // namespace reduced

template <>
inline Quotient<reduced::Integer>& Quotient<reduced::Integer>::operator+=(const Quotient& other) {
    reduced::add(*this, other, std::plus<>());
    return *this;
}
template <>
inline Quotient<reduced::Integer>& Quotient<reduced::Integer>::operator-=(const Quotient& other) {
    reduced::add(*this, other, std::minus<>());
    return *this;
}
template <>
inline Quotient<reduced::Integer>& Quotient<reduced::Integer>::operator*=(const Quotient& other) {
    reduced::multiply(*this, other.num, other.den);
    return *this;
}
template <>
inline Quotient<reduced::Integer>& Quotient<reduced::Integer>::operator/=(const Quotient& other) {
    CGAL_precondition(other.num != 0);
    reduced::multiply(*this, other.den, other.num);
    return *this;
}

}  // namespace CGAL
