/// The kernels over which tests run.
#pragma once

#include <concepts>
#include <utility>

#include "vidno/kernels/bits.h"
#include "vidno/kernels/exact.h"
#include "vidno/kernels/filtered.h"
#include "vidno/kernels/grid.h"
#include "vidno/kernels/machine.h"
#include "vidno/snap.h"

namespace vidno::test {

struct Bits24 : Bits {
    Bits24() : Bits(24) {}
};
struct Grid8 : Grid {
    Grid8() : Grid(8) {}
};

/// The scene as a kernel takes it: `grid` on its grid.
template <class K>
AdmittedScene scene_for(AdmittedScene scene) {
    if constexpr (std::derived_from<K, Grid>) return snapped(std::move(scene), Resolution{8});
    return scene;
}

/// A number of any kernel as the nearest double.
inline double as_double(const auto& number) { return double(number); }
inline double as_double(const Rational& number) { return CGAL::to_double(number); }

}  // namespace vidno::test

/// The kernels over which every hand-computed case runs, and those of them that run the printed text.
#define VIDNO_PRINTED_KERNELS ::vidno::Float, ::vidno::Double, ::vidno::test::Bits24, ::vidno::Exact
#define VIDNO_KERNELS VIDNO_PRINTED_KERNELS, ::vidno::Filtered, ::vidno::test::Grid8
