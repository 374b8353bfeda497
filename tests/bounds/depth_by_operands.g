# code: lib/vidno/kernels/plane_depths.h: const bool certain = std::abs(difference) > 2 * (z.plane->error + than.plane->error);
# code: lib/vidno/kernels/filtered.h: const bool apart = std::abs(a.value - b.value) > 2 * (a.error + b.error);
#
# The difference of two numbers has the sign of the exact one where it exceeds twice the sum of their errors: sum and difference are rounded.

factor = 2;  # constant: no less

{ r1 in [-1b-53, 1b-53] /\ r2 in [-1b-53, 1b-53]
-> 1 / (factor * (1 + r1) * (1 + r2)) in [0, 0.999] }
