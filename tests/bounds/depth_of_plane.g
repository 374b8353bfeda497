# code: lib/vidno/kernels/filtered.h: greatest(x_slope) * farthest_out + (greatest(y_slope) * farthest_out + greatest(at_origin));
# code: lib/vidno/kernels/approximate_plane.h: double depth(double x, double y) const { return x_slope * x + (y_slope * y + at_origin); }
# code: lib/vidno/kernels/bounded.h: static constexpr double unit = std::numeric_limits<double>::epsilon();
#
# The bound of a depth, at the farthest point of the scene and so at every other: where |x| and |y| are less, the products and sums of a depth
# are no greater, so that they are rounded by no more. p, q and s are the exact x_slope.error * farthest_out, y_slope.error * farthest_out and
# at_origin.error, of which 0.51 may be wrong (bounded_sum.g). The other names are those of bounded_product.g.

unit = 1b-52;  # constant: no less
underflow = 1b-1021;  # underflow.g has more
x_product = ((p * (1 + r1) + u1 + unit / 1b-53 * half1) * (1 + r2) + underflow) * (1 + r3);
y_product = ((q * (1 + r4) + u2 + unit / 1b-53 * half2) * (1 + r5) + underflow) * (1 + r6);
sum = (y_product + (s + unit / 1b-53 * half3) * (1 + r7)) * (1 + r8);
error = (x_product + (sum + unit / 1b-53 * half4) * (1 + r9)) * (1 + r10);
wrong = 0.51 * (p + q + s) + half1 + half2 + half3 + half4 + v1 + v2;

{ p in [0, 1b2048] /\ q in [0, 1b2048] /\ s in [0, 1b1024]
/\ half1 in [0, 1b1024] /\ half2 in [0, 1b1024] /\ half3 in [0, 1b1024] /\ half4 in [0, 1b1024]
/\ r1 in [-1b-53, 1b-53] /\ r2 in [-1b-53, 1b-53] /\ r3 in [-1b-53, 1b-53] /\ r4 in [-1b-53, 1b-53] /\ r5 in [-1b-53, 1b-53]
/\ r6 in [-1b-53, 1b-53] /\ r7 in [-1b-53, 1b-53] /\ r8 in [-1b-53, 1b-53] /\ r9 in [-1b-53, 1b-53] /\ r10 in [-1b-53, 1b-53]
/\ u1 in [-1b-1075, 1b-1075] /\ u2 in [-1b-1075, 1b-1075] /\ v1 in [0, 1b-1075] /\ v2 in [0, 1b-1075]
-> error - wrong >= 0 }

error - wrong ->
    p * ((1 + r1) * (1 + r2) * (1 + r3) * (1 + r10) - 0.51)
    + q * ((1 + r4) * (1 + r5) * (1 + r6) * (1 + r8) * (1 + r9) * (1 + r10) - 0.51)
    + s * ((1 + r7) * (1 + r8) * (1 + r9) * (1 + r10) - 0.51)
    + half1 * (unit / 1b-53 * (1 + r2) * (1 + r3) * (1 + r10) - 1)
    + half2 * (unit / 1b-53 * (1 + r5) * (1 + r6) * (1 + r8) * (1 + r9) * (1 + r10) - 1)
    + half3 * (unit / 1b-53 * (1 + r7) * (1 + r8) * (1 + r9) * (1 + r10) - 1)
    + half4 * (unit / 1b-53 * (1 + r9) * (1 + r10) - 1)
    + ((u1 * (1 + r2) + underflow) * (1 + r3) * (1 + r10) - v1)
    + ((u2 * (1 + r5) + underflow) * (1 + r6) * (1 + r8) * (1 + r9) * (1 + r10) - v2);
