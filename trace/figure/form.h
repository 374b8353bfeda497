/// Form: a ruled table, blank or filled in.
#pragma once

#include "drawing.h"

namespace vidno::figures {

struct Form {
    struct Column {
        std::string heading;
        double share;  // of the width
    };
    struct Cell {
        std::string text;
        bool is_given = false;  // else it is an answer
    };

    std::vector<Column> columns;
    /// Where a row has fewer cells than columns, its last cell spans the rest.
    std::vector<std::vector<Cell>> rows;
    double row_height = for_a_pen;  // millimetres

    static constexpr double for_a_pen = 6.4, heading_height = 5;

    double height() const { return heading_height + double(rows.size()) * row_height; }
};

/// The form with this width. Answers are filled in or left blank; nothing else depends on that.
Drawing drawn(const Form& form, double width, bool answered);

}  // namespace vidno::figures
