# code: lib/vidno/kernels/plane_depths.h: depth_error_ = std::max(depth_error_, 4 * plane.error);
#
# The difference of two depths has the sign of the exact one where it exceeds this, in units of the greatest error. Each depth is wrong by at
# most that, and the difference is rounded.

factor = 4;  # constant: no less

{ w1 in [-1, 1] /\ w2 in [-1, 1] /\ r in [-1b-53, 1b-53]
-> (w1 - w2) / (factor * (1 + r)) in [-0.999, 0.999] }
