// Included before everything else. Without GMP, rationals are quotients of Boost's integers, and each result is
// reduced. Boost 1.74 subtracts and shifts for each bit, which takes most of the time of a run in exact numbers.
#pragma once

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>

namespace boost::multiprecision::backends {

using LongInteger = cpp_int::backend_type;

/// The number of zero bits at the end; the integer must not be zero.
inline unsigned trailing_zeros(const LongInteger& n) {
    unsigned limb = 0;
    while (n.limbs()[limb] == 0) ++limb;
    return limb * LongInteger::limb_bits + unsigned(std::countr_zero(n.limbs()[limb]));
}

/// For a positive integer.
inline bool is_power_of_two(const LongInteger& n) {
    const auto* top = n.limbs() + n.size() - 1;
    return std::has_single_bit(*top) && std::all_of(n.limbs(), top, [](limb_type each) { return each == 0; });
}

inline bool fits_64_bits(const LongInteger& n) { return n.size() * LongInteger::limb_bits <= 64; }

/// The lowest 64 bits of |n| / 2^shift.
inline std::uint64_t bits_from(const LongInteger& n, unsigned shift) {
    std::uint64_t bits = 0;
    for (unsigned i = shift / LongInteger::limb_bits; i < n.size() && i * LongInteger::limb_bits < shift + 64; ++i) {
        const std::uint64_t limb = n.limbs()[i];
        const unsigned begin = i * LongInteger::limb_bits;
        bits |= begin < shift ? limb >> (shift - begin) : limb << (begin - shift);
    }
    return bits;
}

/// Several steps of Euclid's algorithm at once: they turn (u, v) into (|a u - b v|, |c u - d v|).
struct EuclideanSteps {
    std::uint64_t a = 1, b = 0, c = 0, d = 1;
};

/// The steps that u and v take for certain, from their leading bits, u >= v (Lehmer; Knuth, The Art of Computer
/// Programming 2, 4.5.2, algorithm L). The factors have at most 32 bits.
inline EuclideanSteps certain_steps(std::int64_t u, std::int64_t v) {
    std::int64_t a = 1, b = 0, c = 0, d = 1;
    while (v + c != 0 && v + d != 0) {
        const std::int64_t quotient = (u + a) / (v + c);
        if (quotient >> 28 != 0) break;  // rare; the products below would not fit
        const std::int64_t rest = u + b - quotient * (v + d);
        if (rest < 0 || rest >= v + d) break;  // the other bound has another quotient
        const std::int64_t next_c = a - quotient * c, next_d = b - quotient * d;
        if (std::max(std::abs(next_c), std::abs(next_d)) >> 32 != 0) break;
        a = std::exchange(c, next_c);
        b = std::exchange(d, next_d);
        u = std::exchange(v, u - quotient * v);
    }
    const auto size = [](std::int64_t factor) { return std::uint64_t(std::abs(factor)); };
    return {size(a), size(b), size(c), size(d)};
}

inline void apply(const EuclideanSteps& steps, LongInteger& u, LongInteger& v) {
    const auto difference = [&](std::uint64_t of_u, std::uint64_t of_v) {
        LongInteger minuend, subtrahend;
        eval_multiply(minuend, u, limb_type(of_u));
        eval_multiply(subtrahend, v, limb_type(of_v));
        eval_subtract(minuend, subtrahend);
        minuend.sign(false);
        return minuend;
    };
    LongInteger next = difference(steps.a, steps.b);
    v = difference(steps.c, steps.d);
    u.swap(next);
}

/// The greatest common divisor of u and v, neither negative.
inline LongInteger lehmer_gcd(LongInteger u, LongInteger v) {
    if (u.compare(v) < 0) u.swap(v);
    while (!fits_64_bits(v)) {
        const unsigned shift = unsigned(eval_msb(u)) - 61;
        const EuclideanSteps steps =
            certain_steps(std::int64_t(bits_from(u, shift)), std::int64_t(bits_from(v, shift)));
        if (steps.b != 0) {
            apply(steps, u, v);
        } else {
            LongInteger remainder;
            eval_modulus(remainder, u, v);
            u.swap(v);
            v.swap(remainder);
        }
    }
    if (eval_get_sign(v) == 0) return u;
    LongInteger remainder;
    eval_modulus(remainder, u, v);
    LongInteger divisor;
    divisor = static_cast<unsigned long long>(std::gcd(bits_from(remainder, 0), bits_from(v, 0)));
    return divisor;
}

// Overload resolution prefers this function, which is no template, to Boost's own.
inline void eval_gcd(LongInteger& result, const LongInteger& a, const LongInteger& b) {
    if (fits_64_bits(a) && fits_64_bits(b)) {
        result = static_cast<unsigned long long>(std::gcd(bits_from(a, 0), bits_from(b, 0)));
        return;
    }
    // Most denominators are powers of two, since the numbers of a scene are doubles.
    if (eval_get_sign(a) != 0 && eval_get_sign(b) > 0 && is_power_of_two(b)) {
        const unsigned zeros = std::min(trailing_zeros(a), trailing_zeros(b));
        result = limb_type{1};
        eval_left_shift(result, zeros);
        return;
    }
    LongInteger u = a, v = b;
    u.sign(false);
    v.sign(false);
    result = lehmer_gcd(std::move(u), std::move(v));
}

}  // namespace boost::multiprecision::backends
