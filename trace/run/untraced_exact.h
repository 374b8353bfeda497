/// Runs without a trace under `exact`, compiled in two units, since one would take too long.
#pragma once

#include "run/untraced_set.h"
#include "vidno/kernels/exact.h"

namespace vidno {

template <>
struct KernelOf<KernelKind::exact> {
    static Exact made(int) { return Exact{}; }
};

}  // namespace vidno
