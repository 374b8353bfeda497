#include "table.h"

#include "characters.h"
#include "plane.h"
#include "wrap.h"

namespace vidno::figures {

namespace {

constexpr double indent = 2.6;      // room for the arrow
constexpr double base_below = 1.1;  // from the baseline of a line of text to its lower end
constexpr double column_gap = 1.2;  // between columns
constexpr double below_rule = 0.5;  // extra space below a rule

/// Draws a rule. Returns the y of the next line.
double rule(Drawing& to, double y, double width) {
    to.add(Path{{{{0, y}, {to.width, y}}}, false, {}, Stroke{ink, width}});
    return y + below_rule;
}

}  // namespace

void add_arrow(Drawing& to, double x, double base) {
    to.add(Path{{{{x, base - 2}, {x + 1.6, base - 1}, {x, base}}}, true, ink, {}});
}

std::string fitted(std::string text, double width, double size, bool bold) {
    if (width_of(text, size, bold) <= width) return text;
    auto characters = characters_of(text);
    do {
        characters.pop_back();
        text.clear();
        for (const char32_t c : characters) text += utf8(c);
        text += "…";
    } while (!characters.empty() && width_of(text, size, bold) > width);
    return text;
}

void shorten(Table& table, const FigureWords& words) {
    constexpr std::size_t most_rows = 12;
    if (table.rows.size() <= most_rows) return;
    const std::size_t first = std::min(table.current.value_or(0), table.rows.size() - most_rows);
    const std::string others = std::string(words.more) + " " + std::to_string(table.rows.size() - most_rows);
    table.below.insert(table.below.begin(), others);
    table.rows.erase(table.rows.begin(), table.rows.begin() + std::ptrdiff_t(first));
    table.rows.resize(most_rows);
    if (table.current) *table.current -= first;
}

Drawing drawn(const Table& table, double width, double letters) {
    Drawing drawing{width, 0};
    double y = line_height;
    const auto put = [&](const std::string& text, double x, Anchor anchor, double size, bool bold) {
        drawing.add(Label{text, {x, y - base_below}, size, anchor, bold, ink});
    };
    const double note_width = letters * width_of(table.note, small_size);
    put(fitted(table.title, (width - note_width - column_gap) / letters, text_size, true), 0, Anchor::start, text_size,
        true);
    if (!table.note.empty()) put(table.note, width, Anchor::end, small_size, false);
    y = rule(drawing, y, 0.75);

    const auto put_row = [&](const auto& cell_of, double size) {
        y += line_height;
        double from = indent;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const auto& [heading, share, anchor] = table.columns[i];
            const Table::Cell cell = cell_of(i);
            const double column = share * (width - indent);
            constexpr double side = 2;
            const double shift = cell.square ? side + 0.8 : 0;
            if (cell.square) {
                drawing.add(rectangle({from, y - base_below - side, side, side}, *cell.square, Stroke{ink}));
            }
            const double x = anchor == Anchor::end ? from + column - column_gap : from + shift;
            put(fitted(cell.text, (column - column_gap - shift) / letters, size), x, anchor, size, false);
            from += column;
        }
    };
    put_row([&](std::size_t column) { return Table::Cell{table.columns[column].heading}; }, small_size);
    y = rule(drawing, y, 0.5);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (row == table.current) {
            drawing.add(rectangle({0, y + 0.15, width, line_height - 0.15}, band));
            add_arrow(drawing, 0.4, y + line_height - base_below - 0.1);
        }
        put_row([&](std::size_t column) { return table.rows[row][column]; }, text_size);
    }
    const double room = (width - indent) / letters;
    for (const auto& text : table.below) {
        for (const auto& line : wrapped(text, small_size, room, room)) {
            y += line_height;
            put(fitted(line, room, small_size), indent, Anchor::start, small_size, false);
        }
    }
    rule(drawing, y + 0.3, 0.75);
    drawing.height = y + 0.6;
    return drawing;
}

}  // namespace vidno::figures
