/// Report: the grade of a program, for the student who wrote it, and a table of the grades of a folder, for the teacher.
#pragma once

#include "grade/grade.h"

namespace vidno {

/// The verdict, the first failure, the mistake if it is known, the differences, and a line for each scene.
std::string report_of(const ProgramGrade& grade, const Grading& grading);

/// The smallest scene that shows the failure: its area, its polygons or curves, and the failure.
std::string report_of_smallest(const SceneGrade& smallest, const Grading& grading);

/// A program of a folder. If it could not be judged, it has no grade and `reason` says why.
struct TableRow {
    std::string program;
    std::optional<ProgramGrade> grade;
    std::string reason;
};

/// UTF-8 text of the table: with a heading line, or an array of objects.
std::string table_as_csv(const std::vector<TableRow>& rows, const Words& say);
std::string table_as_json(const std::vector<TableRow>& rows, const Words& say);

}  // namespace vidno
