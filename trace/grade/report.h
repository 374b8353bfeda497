/// Report: what came of a program, for the student who wrote it; and of a folder of them, as a table for who teaches them.
#pragma once

#include "grade/grade.h"

namespace vidno {

/// The scenes one by one, what is different, the verdict, and the first failure with the mistake that it is, if it is a known one.
std::string report_of(const ProgramGrade& grade, std::size_t scenes_given, const Grading& grading);

/// The smallest scene on which the failure is still seen.
std::string report_of_smallest(const SceneGrade& smallest, const Grading& grading);

/// A program of a folder. Without a grade it could not be judged, and `reason` says why.
struct TableRow {
    std::string program;
    std::optional<ProgramGrade> grade;
    std::string reason;
};

std::string table_as_csv(const std::vector<TableRow>& rows, const Words& say);
std::string table_as_json(const std::vector<TableRow>& rows, const Words& say);

}  // namespace vidno
