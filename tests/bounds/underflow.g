# code: lib/vidno/kernels/bounded.h: static constexpr double underflow = 0x1p-990;
#
# The bounds of products and quotients need 2^-1021. Divided by the distance of any two pixels that areas may have (scene.h), 2^31 + 2^14,
# the constant is a normal number. So the bound of the slope of a vertical edge is one, too: with a subnormal number, a division takes many
# times as long.

underflow = 1b-990;  # constant: no less

{ distance in [1, 2147500032] -> underflow >= 1b-1021 /\ underflow / distance >= 1b-1022 }
