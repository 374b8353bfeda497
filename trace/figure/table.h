/// Table: rows of text under a heading, ruled as in books.
#pragma once

#include <optional>

#include "drawing.h"
#include "figure_words.h"

namespace vidno::figures {

struct Table {
    struct Column {
        std::string heading;
        double share;  // of the width
        Anchor anchor = Anchor::start;
    };

    /// A cell of text, preceded by a coloured square if it has a colour.
    struct Cell {
        std::string text;
        std::optional<Color> square{};
    };

    std::string title{};
    std::string note{};  // at the end of the title's line
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows{};
    std::optional<std::size_t> current{};  // the row that is marked
    std::vector<std::string> below{};      // last texts, which may take several lines
};

inline constexpr double text_size = 8, small_size = 7;  // points
inline constexpr double line_height = 3.6;              // millimetres
inline constexpr Color band{0xe6, 0xe6, 0xe6};          // behind the current row, beside its arrow

/// The arrow before the current row, in a line of text with this base line.
void add_arrow(Drawing& to, double x, double base);

/// Text cut to a width, with an ellipsis.
std::string fitted(std::string text, double width, double size, bool bold = false);

/// Cuts a table with too many rows around its current row, which is then on top if possible.
void shorten(Table& table, const FigureWords& words);

/// Draws the table with this width; the height follows from the rows. `letters` is the width of the letters relative to
/// Helvetica.
Drawing drawn(const Table& table, double width, double letters);

}  // namespace vidno::figures
