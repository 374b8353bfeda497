# code: lib/vidno/kernels/plane_depths.h: static constexpr float cell_error = 0x1p-18F;
# code: lib/vidno/kernels/plane_depths.h: plane.fits_cells = plane.error < cell_error / 16 && std::all_of(vertices.begin(), vertices.end(), within_cells);
# code: lib/vidno/kernels/plane_depths.h: const auto within_cells = [&](const auto& v) { return std::abs(plane.depth(double(v.x), double(v.y))) < 2; };
#
# A depth in a cell, float(float(steps * float(slope)) + float(first)), against the exact one. The plane of the computed coefficients, taken
# exactly, has the depth `first` where the steps begin and `first + rise` at the pixel: both within the limit, but for the plane's error, since
# the pixels lie in the polygon. The double `first` is wrong by one plane's error, w1, the plane by another, w2. A float loses at most 2^-150
# by underflow, the slope that times 2^14 steps. The goal is half of the bound for either of the two depths; the thousandth that it leaves pays
# for the rounding of their difference.

cell_error = 1b-18;  # constant: no less
divisor = 16;  # constant: no less
limit = 2;  # constant: no more
plane_error = cell_error / divisor;
reach = limit + plane_error;
first = f * reach;
rise = (f2 - f) * reach;
cell = ((rise * (1 + r1) + u1) * (1 + r2) + u2 + ((first + w1 * plane_error) * (1 + r3) + u3)) * (1 + r4);
exact = first + rise + w2 * plane_error;

{ f in [-1, 1] /\ f2 in [-1, 1] /\ w1 in [-1, 1] /\ w2 in [-1, 1]
/\ r1 in [-1b-24, 1b-24] /\ r2 in [-1b-24, 1b-24] /\ r3 in [-1b-24, 1b-24] /\ r4 in [-1b-24, 1b-24]
/\ u1 in [-1b-136, 1b-136] /\ u2 in [-1b-150, 1b-150] /\ u3 in [-1b-150, 1b-150]
-> (cell - exact) / (cell_error / 2) in [-0.999, 0.999] }

cell - exact ->
    f2 * reach * r4
    + rise * ((1 + r1) * (1 + r2) - 1) * (1 + r4) + (u1 * (1 + r2) + u2 + u3) * (1 + r4)
    + first * r3 * (1 + r4) + w1 * plane_error * (1 + r3) * (1 + r4) - w2 * plane_error;
