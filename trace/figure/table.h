/// Table: rows of text under a heading, ruled as books do it.
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

    /// Text, after a square of a colour if it has one.
    struct Cell {
        std::string text;
        std::optional<Color> square{};
    };

    std::string title{};
    std::string note{};  // at the end of the title's line
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows{};
    std::optional<std::size_t> current{};  // the row that is marked
    std::vector<std::string> below{};      // last lines
};

inline constexpr double text_size = 8, small_size = 7;  // points
inline constexpr double line_height = 3.6;              // millimetres
inline constexpr Color band{0xe6, 0xe6, 0xe6};          // behind what is current, beside its arrow

/// The arrow before what is current, in a line of text with this base.
void add_arrow(Drawing& to, double x, double base);

/// Text cut to a width, with an ellipsis.
std::string fitted(std::string text, double width, double size, bool bold = false);

/// What has too many rows is cut around its current one, which is then on top if it can be.
void shorten(Table& table, const FigureWords& words);

/// So wide; the height follows from the rows. The letters are so much wider than those of Helvetica.
Drawing drawn(const Table& table, double width, double letters);

}  // namespace vidno::figures
