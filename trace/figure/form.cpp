#include "form.h"

#include "plane.h"
#include "table.h"

namespace vidno::figures {

namespace {

/// Adds a vertical line, or lengthens the last one, if that ends where this one begins.
void add_downward(std::vector<Polyline>& lines, double x, double from, double to) {
    Point& end = lines.back().back();
    if (end == Point{x, from}) {
        end.y = to;
    } else {
        lines.push_back({{x, from}, {x, to}});
    }
}

}  // namespace

Drawing drawn(const Form& form, double width, bool answered) {
    constexpr double around = 0.6;       // the least margin around a text
    constexpr double cap_height = 0.72;  // height of a capital letter, as a fraction of the letters' size
    constexpr double least_size = 5;     // points
    Drawing drawing{width, form.height()};
    std::vector<Polyline> lines;
    const auto put = [&](const std::string& text, double left, double column, double top, double height, double size) {
        if (text.empty()) return;
        const double room = column - 2 * around;
        size = std::clamp(size * room / width_of(text, size), least_size, size);
        const double base = top + (height + cap_height * size / points_per_millimetre) / 2;
        drawing.add(Label{fitted(text, room, size), {left + column / 2, base}, size, Anchor::middle, false, ink});
    };
    drawing.add(rectangle({0, 0, width, Form::heading_height}, band));
    for (std::size_t row = 0; row < form.rows.size(); ++row) {
        const double y = Form::heading_height + double(row) * form.row_height;
        lines.push_back({{0, y}, {width, y}});
    }
    double left = 0;
    for (std::size_t i = 0; i < form.columns.size(); ++i) {
        const auto& [heading, share] = form.columns[i];
        const double column = share * width;
        if (i > 0) lines.push_back({{left, 0}, {left, Form::heading_height}});
        put(heading, left, column, 0, Form::heading_height, small_size);
        for (std::size_t row = 0; row < form.rows.size(); ++row) {
            const auto& cells = form.rows[row];
            if (i >= cells.size()) continue;
            const double y = Form::heading_height + double(row) * form.row_height;
            if (i > 0) add_downward(lines, left, y, y + form.row_height);
            const bool is_last = i + 1 == cells.size();
            if (cells[i].is_given || answered) {
                put(cells[i].text, left, is_last ? width - left : column, y, form.row_height, text_size);
            }
        }
        left += column;
    }
    drawing.add(Path{std::move(lines), false, {}, Stroke{faint}});
    drawing.add(rectangle({0, 0, width, form.height()}, {}, Stroke{ink, 0.5}));
    return drawing;
}

}  // namespace vidno::figures
