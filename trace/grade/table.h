/// Table: the grades of the programs in a folder, a line for each, for the teacher.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grade/grade.h"

namespace vidno {

/// The formats of a table: a heading and lines of cells, or an array of objects.
enum class TableFormat : unsigned char { csv, json };

/// The format of a table's file, by its extension; none for another.
std::optional<TableFormat> table_format_of(const std::string& file);

/// A program's line.
struct TableLine {
    std::string program;  // its name
    std::string text;
    bool is_right;
};

TableLine line_of(std::string program, const ProgramGrade& grade, TableFormat format, const Words& say);
/// The line of a program that could not be judged.
TableLine line_of(std::string program, const std::string& reason, TableFormat format);

/// The UTF-8 text of a table, in the order of the programs' names.
std::string table_of(std::vector<TableLine> lines, TableFormat format);

/// The lines of a table's text. Throws Refused.
std::vector<TableLine> lines_of(const std::string& text, TableFormat format, const std::string& file);

}  // namespace vidno
