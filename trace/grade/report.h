/// Report: the grade of a program, for the student who wrote it.
#pragma once

#include "grade/grade.h"

namespace vidno {

/// The verdict, the first failure, the mistake if it is known, the differences, and a line for each scene.
std::string report_of(const ProgramGrade& grade, const Grading& grading);

/// The smallest scene that shows the failure: its area, its polygons or curves, and the failure.
std::string report_of_smallest(const SceneGrade& smallest, const Grading& grading);

}  // namespace vidno
