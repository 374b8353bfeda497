/// The scenes on which a student's program is graded.
#pragma once

#include <vector>

#include "vidno/scene.h"

namespace vidno {

/// Small ones, ordinary first, each with one idea in its name.
std::vector<Scene> scenes_to_grade();

}  // namespace vidno
