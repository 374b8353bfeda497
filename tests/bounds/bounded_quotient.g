# code: lib/vidno/kernels/bounded.h: return {value, (a.error + std::abs(value) * b.error + Bounded::underflow) / least_divisor +
# code: lib/vidno/kernels/bounded.h: Bounded::unit * std::abs(value) + Bounded::underflow};
#
# The bound of a quotient, with the names of bounded_product.g. The exact divisor is at least d = |b.value| - b.error, and the value is wrong
# by at most
#     (share * a.error + |a.value / b.value| * share * b.error) / d + half + v,
# where |a.value / b.value| <= |value| * (1 + 2^-53) + 2^-1075. The terms over d are p = a.error / d, q = |value| b.error / d, s = 1 / d and
# t = b.error / d. The last is at most 2^53, since b.error and |b.value| are different doubles.

unit = 1b-52;  # constant: no less
underflow = 1b-1021;  # underflow.g has more
growth = 1b-49;
over_d = ((p + (q * (1 + r1) + u1 * s)) * (1 + r2) + underflow * s) * (1 + r3) * (1 + r4);
error = ((over_d * (1 + r5) + u2 + unit / 1b-53 * half) * (1 + r6) + underflow) * (1 + r7);
wrong = share * p + share * (1 + 1b-53) * q + share * 1b-1075 * t + half + v;

{ share in [0.5, 0.51] /\ p in [0, 1b2098] /\ q in [0, 1b3122] /\ s in [0, 1b1074] /\ t in [0, 1b53] /\ half in [0, 1b1024]
/\ r1 in [-1b-53, 1b-53] /\ r2 in [-1b-53, 1b-53] /\ r3 in [-1b-53, 1b-53] /\ r4 in [-1b-53, 1b-53]
/\ r5 in [-1b-53, 1b-53] /\ r6 in [-1b-53, 1b-53] /\ r7 in [-1b-53, 1b-53]
/\ u1 in [-1b-1075, 1b-1075] /\ u2 in [-1b-1075, 1b-1075] /\ v in [0, 1b-1075]
-> share * (1 + growth) * error - wrong >= 0 }

share * (1 + growth) * error - wrong ->
    share * p * ((1 + growth) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5) * (1 + r6) * (1 + r7) - 1)
    + share * q * ((1 + growth) * (1 + r1) * (1 + r2) * (1 + r3) * (1 + r4) * (1 + r5) * (1 + r6) * (1 + r7) - (1 + 1b-53))
    + share * s * (u1 * (1 + r2) + underflow) * ((1 + growth) * (1 + r3) * (1 + r4) * (1 + r5) * (1 + r6) * (1 + r7))
    + half * ((1 + growth) * (1 + r6) * (1 + r7) * share * unit / 1b-53 - 1)
    + (share * ((1 + growth) * (1 + r7) * (u2 * (1 + r6) + underflow) - 1b-1075 * t) - v);
