// Included before everything else. Without GMP, rationals are quotients of Boost's integers, and each result is reduced. Most
// denominators are powers of two, since the numbers of a scene are doubles. Boost 1.74 would subtract and shift hundreds of times.
#pragma once

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <memory>

namespace boost::multiprecision::backends {

/// The number of zero bits at the end; the integer must not be zero.
inline unsigned trailing_zeros(const cpp_int::backend_type& n) {
    unsigned limb = 0;
    while (n.limbs()[limb] == 0) ++limb;
    return limb * cpp_int::backend_type::limb_bits + unsigned(std::countr_zero(n.limbs()[limb]));
}

/// For a positive integer.
inline bool is_power_of_two(const cpp_int::backend_type& n) {
    const auto* top = n.limbs() + n.size() - 1;
    return std::has_single_bit(*top) && std::all_of(n.limbs(), top, [](limb_type each) { return each == 0; });
}

// Overload resolution prefers this function, which is no template, to Boost's own.
inline void eval_gcd(cpp_int::backend_type& result, const cpp_int::backend_type& a, const cpp_int::backend_type& b) {
    if (eval_get_sign(a) == 0 || eval_get_sign(b) <= 0 || !is_power_of_two(b)) {
        return eval_gcd<0, 0, signed_magnitude, unchecked, std::allocator<limb_type>>(result, a, b);
    }
    result = limb_type{1};
    eval_left_shift(result, std::min(trailing_zeros(a), trailing_zeros(b)));
}

}  // namespace boost::multiprecision::backends
