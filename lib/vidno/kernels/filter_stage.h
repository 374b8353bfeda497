/// FilterStage: what decided a comparison of the kernel `filtered`.
#pragma once

#include <array>
#include <string_view>

namespace vidno {

enum class FilterStage : unsigned char {
    given,     // nothing was rounded: coordinates of the scene compare directly
    scene,     // a bound on the error of every such comparison in the scene
    operands,  // a bound on the errors of these operands
    exact      // CGAL's predicate or rationals
};
inline constexpr std::array<std::string_view, 4> filter_stage_names{"given", "scene", "operands", "exact"};

/// Receives, for each comparison, what decided it; ignores it.
struct NoTally {
    void operator()(FilterStage) const {}
};

}  // namespace vidno
