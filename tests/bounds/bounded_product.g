# code: lib/vidno/kernels/bounded.h: return {value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error +
# code: lib/vidno/kernels/bounded.h: Bounded::unit * std::abs(value) + Bounded::underflow};
#
# The bound of a product, with the names of bounded_sum.g: p, q and s are the exact |a.value| b.error, |b.value| a.error and a.error b.error.
# Each product may also lose half of the least double, u or v. A subnormal value has no `half`, only v. The value is wrong by at most
# share * (p + q) + share^2 * s, and share^2 is at most the share.

unit = 1b-52;  # constant: no less
underflow = 1b-1021;  # underflow.g has more
growth = 1b-49;
error = ((((p * (1 + r1) + u1 + (q * (1 + r2) + u2)) * (1 + r3) + (s * (1 + r4) + u3)) * (1 + r5)
    + unit / 1b-53 * half) * (1 + r6) + underflow) * (1 + r7);
wrong = share * p + share * q + share * s + half + v;

{ share in [0.5, 0.51] /\ p in [0, 1b2048] /\ q in [0, 1b2048] /\ s in [0, 1b2048] /\ half in [0, 1b1024]
/\ r1 in [-1b-53, 1b-53] /\ r2 in [-1b-53, 1b-53] /\ r3 in [-1b-53, 1b-53] /\ r4 in [-1b-53, 1b-53]
/\ r5 in [-1b-53, 1b-53] /\ r6 in [-1b-53, 1b-53] /\ r7 in [-1b-53, 1b-53]
/\ u1 in [-1b-1075, 1b-1075] /\ u2 in [-1b-1075, 1b-1075] /\ u3 in [-1b-1075, 1b-1075] /\ v in [0, 1b-1075]
-> share * (1 + growth) * error - wrong >= 0 }

share * (1 + growth) * error - wrong ->
    share * p * ((1 + growth) * (1 + r1) * (1 + r3) * (1 + r5) * (1 + r6) * (1 + r7) - 1)
    + share * q * ((1 + growth) * (1 + r2) * (1 + r3) * (1 + r5) * (1 + r6) * (1 + r7) - 1)
    + share * s * ((1 + growth) * (1 + r4) * (1 + r5) * (1 + r6) * (1 + r7) - 1)
    + half * ((1 + growth) * (1 + r6) * (1 + r7) * share * unit / 1b-53 - 1)
    + (share * (1 + growth) * (1 + r7) * (((u1 + u2) * (1 + r3) + u3) * (1 + r5) * (1 + r6) + underflow) - v);
