/// The scenes on which a student's program is graded.
#pragma once

#include <vector>

#include "vidno/scene.h"

namespace vidno {

/// Small ones, ordinary first, each with one idea in its name.
std::vector<Scene> scenes_to_grade();

/// So many more, drawn at random, the same for a seed on every machine: by turns convex polygons anywhere in an area of any size, and one
/// of the families in which vertices lie on centres, on edges and on each other.
std::vector<Scene> random_scenes_to_grade(unsigned seed, int count);

}  // namespace vidno
