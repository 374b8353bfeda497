/// The functions of formulas that libraries round differently. Here they have the same values on every machine. They
/// take microseconds, so the page has quicker ones (trace/wasm/elementary.cpp).
#pragma once

/// Calls `with(name)` for the name of each function of one argument.
#define VIDNO_ELEMENTARY(with)                                                                                  \
    with(sin) with(cos) with(tan) with(asin) with(acos) with(atan) with(sinh) with(cosh) with(tanh) with(asinh) \
        with(acosh) with(atanh) with(exp) with(log) with(log2) with(log10)

namespace vidno::elementary {

#define VIDNO_DECLARED(name) double name(double x);
VIDNO_ELEMENTARY(VIDNO_DECLARED)
#undef VIDNO_DECLARED

double atan2(double y, double x);
double pow(double base, double exponent);

}  // namespace vidno::elementary
