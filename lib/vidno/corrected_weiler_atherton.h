/// CorrectedWeilerAtherton: Weiler and Atherton's algorithm. The only set for regions; corrected.h explains sets.
#pragma once

#include "corrected_polygons.h"
#include "weiler_atherton/depth_sort.h"
#include "weiler_atherton/paint_regions.h"
#include "weiler_atherton/region_clip.h"
#include "weiler_atherton/remove_behind.h"
#include "weiler_atherton/split_piercing.h"
#include "weiler_atherton/weiler_atherton.h"

namespace vidno {

struct CorrectedWeilerAtherton : CorrectedPolygons,
                                 WeilerAtherton,
                                 SplitPiercing,
                                 DepthSort,
                                 RegionClip,
                                 RemoveBehind,
                                 PaintRegions {};

}  // namespace vidno
