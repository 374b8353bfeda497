/// Runs without a trace under `filtered`, compiled in two units, since one would take too long.
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
