# code: lib/vidno/kernels/bounded.h: double outward() const { return error + unit * std::abs(value); }
#
# The value minus `outward`, rounded, is at most the exact result, and their sum is at least that. The names are those of bounded_sum.g. An
# error that is not 0 is at least an ulp of the value, 2 * half; `more` is the rest. The difference is rounded by at most 2^-53 of itself, and
# so of |value|, which is less than 2 * half, and of `outward`.

unit = 1b-52;  # constant: no less
error = 2 * half + more;
outward = (error + unit / 1b-53 * half) * (1 + r);
rounded = 2 * half + 1b-53 * outward;

{ share in [0.5, 0.51] /\ half in [0, 1b1024] /\ more in [0, 1b1024] /\ r in [-1b-53, 1b-53]
-> outward - rounded - share * error >= 0 }

outward - rounded - share * error ->
    more * ((1 - 1b-53) * (1 + r) - share) + half * ((2 + unit / 1b-53) * (1 - 1b-53) * (1 + r) - 2 - 2 * share);
