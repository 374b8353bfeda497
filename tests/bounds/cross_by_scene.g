# code: lib/vidno/kernels/filtered.h: cross_error_ = 16 * extent_ * extent_ * Bounded::unit;
#
# The cross product as the doubles compute it, in units of the extent. A difference of two coordinates is at most 2 extents. The extent
# is at least 1, since a window is: so no difference underflows, and a product loses at most half of the least double.
# The last subtraction, left - right, has the sign of its operands' difference, and makes it greater by less than the thousandth that the goal
# leaves, which pays for the rounding of the bound, too. For 12 units the proof fails, by the products of two roundoffs.

left = d1 * (1 + e1) * (d2 * (1 + e2)) * (1 + e3) + u1;
right = d3 * (1 + e4) * (d4 * (1 + e5)) * (1 + e6) + u2;
exact = d1 * d2 - d3 * d4;
bound = 16b-52;  # constant: no less

{ d1 in [-2, 2] /\ d2 in [-2, 2] /\ d3 in [-2, 2] /\ d4 in [-2, 2]
/\ e1 in [-1b-53, 1b-53] /\ e2 in [-1b-53, 1b-53] /\ e3 in [-1b-53, 1b-53]
/\ e4 in [-1b-53, 1b-53] /\ e5 in [-1b-53, 1b-53] /\ e6 in [-1b-53, 1b-53]
/\ u1 in [-1b-1075, 1b-1075] /\ u2 in [-1b-1075, 1b-1075]
-> (left - right - exact) / bound in [-0.999, 0.999] }

left - d1 * d2 -> d1 * d2 * ((1 + e1) * (1 + e2) * (1 + e3) - 1) + u1;
right - d3 * d4 -> d3 * d4 * ((1 + e4) * (1 + e5) * (1 + e6) - 1) + u2;
