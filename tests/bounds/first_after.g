# code: lib/vidno/kernels/filter_bounds.h: const double distance = std::min(std::max(0.5, v.value - (low - 0.5)), end - low + 0.5);
# code: lib/vidno/kernels/filter_bounds.h: const bool apart = std::abs(distance - whole - 0.5) + v.error < 0.5 - 0x1p-38;
#
# A value is at no centre if its distance from the middle between two centres and its error are together less than 1/2. The distance of the
# value from the middle before the first centre is rounded; it is at most 2^14 + 1/2, since an area has no more columns and a value off the
# area moves to the nearest middle, past no centre of it. Its differences with a whole number and 1/2 are exact. The sum with
# the error is rounded.

constant = 1b-38;  # constant: no less
distance = float<ieee_64, ne>(exact_distance);
sum = float<ieee_64, ne>(off_and_error);

{ exact_distance in [0.5, 16384.5] /\ sum in [0, 0.5] /\ sum + constant in [0, 0.5]
-> off_and_error + (distance - exact_distance) <= 0.49999999999999 }

off_and_error + (distance - exact_distance) ->
    (sum + constant) - (sum - off_and_error) - constant + (distance - exact_distance);
