/// The scenes on which a student's program is graded.
#pragma once

#include <vector>

#include "vidno/admitted.h"

namespace vidno {

/// Small scenes, the ordinary ones first. The name of each states its idea.
std::vector<AdmittedScene> scenes_to_grade();

/// `count` random scenes, the same for a seed on every machine. Scenes of convex polygons in an area of any size alternate with scenes of
/// the families in which vertices lie on pixel centres, on edges and on each other.
std::vector<AdmittedScene> random_scenes_to_grade(unsigned seed, int count);

}  // namespace vidno
