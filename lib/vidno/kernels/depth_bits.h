/// DepthBits: arithmetic in doubles, and a Z-buffer of B bits.
///
/// There are 2^B evenly spaced depths from -1 to 1, both ends included. A depth is rounded to the nearest of them
/// before it is stored, and compared in that form: depths that round alike are equally near.
///
/// Source  Fixed-point depth as in the OpenGL 4.6 specification, 2.3.5: floor(d (2^B - 1) + 1/2) for d from 0 to 1.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>

#include "number_kernel.h"

namespace vidno {

inline constexpr int fewest_depth_bits = 2;
inline constexpr int most_depth_bits = 32;

struct DepthBits : NumberKernel<double> {
    static constexpr std::string_view name = "depth";

    /// fewest_depth_bits <= bits <= most_depth_bits
    explicit DepthBits(int bits) : steps_(std::ldexp(1, bits) - 1) {
        assert(fewest_depth_bits <= bits && bits <= most_depth_bits);
    }

    double to_store(double z) const {
        const double step = std::floor((z + 1) / 2 * steps_ + 0.5);
        return std::clamp(step, 0.0, steps_) / steps_ * 2 - 1;
    }

private:
    double steps_;  // between neighbouring depths, from -1 to 1
};

}  // namespace vidno
