#include "form.h"

#include "plane.h"
#include "table.h"

namespace vidno::figures {

Drawing drawn(const Form& form, double width, bool answered) {
    constexpr double around = 0.6;       // the least margin around a text
    constexpr double cap_height = 0.72;  // height of a capital letter, as a fraction of the letters' size
    Drawing drawing{width, form.height()};
    std::vector<Polyline> lines;
    const auto put = [&](const std::string& text, double left, double column, double top, double height, double size) {
        if (text.empty()) return;
        const double base = top + (height + cap_height * size / points_per_millimetre) / 2;
        drawing.add(Label{
            fitted(text, column - 2 * around, size), {left + column / 2, base}, size, Anchor::middle, false, ink});
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
        if (i > 0) lines.push_back({{left, 0}, {left, form.height()}});
        put(heading, left, column, 0, Form::heading_height, small_size);
        for (std::size_t row = 0; row < form.rows.size(); ++row) {
            const auto& [text, is_given] = form.rows[row][i];
            const double y = Form::heading_height + double(row) * form.row_height;
            if (is_given || answered) put(text, left, column, y, form.row_height, text_size);
        }
        left += column;
    }
    drawing.add(Path{std::move(lines), false, {}, Stroke{faint}});
    drawing.add(rectangle({0, 0, width, form.height()}, {}, Stroke{ink, 0.5}));
    return drawing;
}

}  // namespace vidno::figures
