# code: lib/vidno/kernels/filtered_heights.h: return {near, 2 * Bounded::unit * std::abs(near) + Bounded::underflow};
#
# CGAL makes a double of a rational that is wrong by at most one of its ulps, in which it is 2^52 to 2^53. As in bounded_sum.g that may be 0.51
# of the bound. A subnormal double loses less than `underflow`.

factor = 2;  # constant: no less
unit = 1b-52;

{ near in [1b52, 1b53] -> 1 / (factor * unit * near) in [0, 0.51] }
