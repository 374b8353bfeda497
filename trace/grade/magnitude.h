/// For the units that judge in exact numbers.
#pragma once

#include "vidno/kernels/exact.h"

namespace vidno {

/// The absolute value. The parameter also takes unevaluated sums and products of rationals.
inline Rational magnitude(const Rational& value) { return value < 0 ? Rational(-value) : value; }

}  // namespace vidno
