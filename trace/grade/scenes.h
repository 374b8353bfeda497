/// The scenes on which a student's program is graded.
#pragma once

#include <vector>

#include "choice/language.h"
#include "scene/surface.h"

namespace vidno {

/// Small scenes, the ordinary ones first. The name of each states its idea. Depths that must be distinguished differ by
/// 1e-7 to 1.
std::vector<AdmittedScene> scenes_to_grade(Language language = Language::english);

/// `count` random scenes, the same for a seed on every machine. Scenes of convex polygons in an area of any size
/// alternate with scenes of the families in which vertices lie on pixel centres, on edges and on each other.
std::vector<AdmittedScene> random_scenes_to_grade(unsigned seed, int count, Language language = Language::english);

/// The surfaces for programs of the floating horizon.
std::vector<Surface> surfaces_to_grade(Language language = Language::english);
std::vector<Surface> random_surfaces_to_grade(unsigned seed, int count, Language language = Language::english);

/// Scenes of both kinds. A program draws those of one.
struct ScenesToGrade {
    std::vector<AdmittedScene> polygons;
    std::vector<Surface> surfaces;
};

}  // namespace vidno
