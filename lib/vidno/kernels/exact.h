/// Exact rationals: every decision is right for the doubles of the scene. The reference of all other kernels.
#pragma once

#include <CGAL/Exact_rational.h>

#include "number_kernel.h"

namespace vidno {

using Rational = CGAL::Exact_rational;

struct Exact : NumberKernel<Rational> {
    static constexpr std::string_view name = "exact";
};

}  // namespace vidno
