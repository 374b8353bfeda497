# code: lib/vidno/kernels/bounded.h: static constexpr double unit = std::numeric_limits<double>::epsilon();
# code: lib/vidno/kernels/bounded.h: error += other.error + unit * std::abs(value);
#
# The bound of a sum, whose value is rounded by at most half an ulp, `half`. The ulp of a normal value is a double, so that unit * |value|,
# which is no less, is rounded to no less. A subnormal sum is exact. Other rounding is written as a product with 1 + r.
#
# If the operands are wrong by at most a share of their bounds, then the sum is wrong by at most (1 + growth) times that share of its own. The
# share begins at 1/2. It reaches 0.51 only after ln(1.02) 2^49 > 2^43 operations in a row, more than any run has.

unit = 1b-52;  # constant: no less
growth = 1b-49;
error = (a + (b + unit / 1b-53 * half) * (1 + r1)) * (1 + r2);
wrong = share * a + share * b + half;

{ share in [0.5, 0.51] /\ a in [0, 1b1024] /\ b in [0, 1b1024] /\ half in [0, 1b1024]
/\ r1 in [-1b-53, 1b-53] /\ r2 in [-1b-53, 1b-53]
-> share * (1 + growth) * error - wrong >= 0 }

share * (1 + growth) * error - wrong ->
    share * a * ((1 + growth) * (1 + r2) - 1)
    + share * b * ((1 + growth) * (1 + r1) * (1 + r2) - 1)
    + half * ((1 + growth) * (1 + r1) * (1 + r2) * share * unit / 1b-53 - 1);
