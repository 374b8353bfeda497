# code: lib/vidno/kernels/filtered.h: 2 * Bounded::unit * (std::abs(left) + std::abs(right)) + Bounded::underflow;
#
# By how much a product may be wrong, as a share of the product that was computed: two differences and the product itself are rounded. The
# bound of the cross product is this share of both products, and the thousandth that the goal leaves pays for the rounding of the bound. What
# the products and the bound lose by underflow, at most half of the least double each, is less than Bounded::underflow.

product = 1 / ((1 + e1) * (1 + e2) * (1 + e3));
bound = 2b-52;  # constant: no less

{ e1 in [-1b-53, 1b-53] /\ e2 in [-1b-53, 1b-53] /\ e3 in [-1b-53, 1b-53]
-> (1 - product) / bound in [-0.999, 0.999] }
