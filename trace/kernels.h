/// The kernels themselves, for what chooses one at run time outside of a run. Heavy to compile: it sees CGAL.
#pragma once

#include "run.h"
#include "vidno/kernels/bits.h"
#include "vidno/kernels/depth_bits.h"
#include "vidno/kernels/filtered.h"
#include "vidno/kernels/machine.h"

namespace vidno {

/// Calls `use` with the kernel of that name.
auto with_kernel(const NamedKernel& named, auto&& use) {
    const auto is = [&](std::string_view name) { return named.choice->name == name; };
    if (is(Float::name)) return use(Float{});
    if (is(Double::name)) return use(Double{});
    if (is(Bits::name)) return use(Bits(named.parameter));
    if (is(DepthBits::name)) return use(DepthBits(named.parameter));
    if (is(Filtered::name)) return use(Filtered{});
    if (is(Grid::name)) return use(Grid(named.parameter));
    assert(is(Exact::name));
    return use(Exact{});
}

}  // namespace vidno
