/// The machine's own numbers, IEEE binary32 and binary64; decisions follow from the rounded values.
#pragma once

#include "number_kernel.h"

namespace vidno {

struct Float : NumberKernel<float> {
    static constexpr std::string_view name = "float";
};

struct Double : NumberKernel<double> {
    static constexpr std::string_view name = "double";
};

}  // namespace vidno
