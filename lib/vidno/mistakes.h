/// Mistakes: the procedure sets with one usual mistake each, as students make it; all else in them is Corrected.
#pragma once

#include <tuple>

#include "mistakes/boundary_outside.h"
#include "mistakes/clip_order_reversed.h"
#include "mistakes/depth_sign_reversed.h"
#include "mistakes/depths_not_cleared.h"
#include "mistakes/integer_division.h"
#include "mistakes/line_for_edge.h"
#include "mistakes/octants_not_split.h"
#include "mistakes/one_list.h"
#include "mistakes/surround_kept.h"
#include "mistakes/vertex_counted_twice.h"
#include "mistakes/y_flipped.h"

namespace vidno {

using Mistakes =
    std::tuple<mistakes::OneList, mistakes::DepthsNotCleared, mistakes::ClipOrderReversed, mistakes::YFlipped,
               mistakes::DepthSignReversed, mistakes::BoundaryOutside, mistakes::IntegerDivision,
               mistakes::SurroundKept, mistakes::VertexCountedTwice, mistakes::OctantsNotSplit, mistakes::LineForEdge>;

}  // namespace vidno
