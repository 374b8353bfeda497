/// A sign map as a drawing.
#pragma once

#include "parts.h"
#include "sign_map/map.h"

namespace vidno::figures {

/// The map with p at the lower left, the border of the exact answers, and below it the meaning of the colours and how
/// many places have each.
Drawing map_figure(const SignMap& map, const Style& style, double width);

}  // namespace vidno::figures
