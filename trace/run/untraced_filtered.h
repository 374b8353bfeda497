/// Runs without a trace under `filtered`, compiled in two units: each would take too long with the other.
#pragma once

#include "run/untraced_set.h"
#include "vidno/kernels/filtered_heights.h"
#include "vidno/kernels/filtered_regions.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::filtered> {
    static Filtered made(int) { return Filtered{}; }
};

}  // namespace vidno
