// The sheets of a surface: its samples and a grid to draw on; then, for each curve, what is found over the columns.

#include <algorithm>
#include <cmath>
#include <utility>

#include "choice/method.h"
#include "floating_horizon_parts.h"
#include "notation.h"
#include "refused.h"
#include "sheet.h"
#include "table.h"
#include "wrap.h"

namespace vidno::figures {

namespace {

constexpr std::size_t curve_room = 10, column_room = 17, row_room = 40;

class CurveWorksheet : Sheet {
public:
    CurveWorksheet(const WorkedCurves& run, Language language, bool answered, const std::optional<ChosenRows>& chosen)
        : Sheet(run.surface().name, std::string(floating_horizon_choice.title.in(language)), language, answered,
                chosen),
          run_(run) {}

    std::vector<Drawing> pages() && {
        add_page();
        add_samples();
        add_grid();
        add_page();
        add_curves();
        return taken_pages();
    }

private:
    static constexpr double name_share = 0.12;  // of the width, for the names of the lines

    const Area& area() const { return run_.scene().area; }
    std::string number(const Value& value) const { return readable(value, language()); }

    // --------------------------------------------------------------------------------- the surface

    void add_samples() {
        constexpr double samples_at = 8;
        constexpr double room = text_width - samples_at;
        add_heading(words().curves);
        y_ += heading_height;
        int name = 0;
        for (const auto& [samples] : run_.scene().curves) {
            std::string text;
            for (const auto& [x, y] : samples) {
                const std::string height = std::isfinite(y) ? in_full(y, language()) : "—";
                text += (text.empty() ? "" : "; ") + pair_of(integer_text(x), height, language());
            }
            const auto lines = wrapped(text, text_size, room, room);
            put(std::to_string(name++), {margin + 2, y_ + line_height}, text_size, Anchor::start, true);
            for (const auto& line : lines) {
                y_ += line_height;
                put(line, {margin + samples_at, y_}, text_size);
            }
            y_ += 0.8;
        }
        add_note(words().height_rule);
        y_ += part_gap;
    }

    void add_grid() {
        constexpr double least_height = 90;
        if (text_bottom - y_ < least_height) add_page();
        add_heading(words().grid);
        y_ += heading_height;
        const Plane plane = plane_in(area(), text_width, text_bottom - y_ - legend_height);
        Drawing drawing{text_width, height_of(plane) + legend_height};
        draw_grid(drawing, plane);
        draw_given(drawing, plane);
        if (is_answered()) {
            draw_horizons(drawing, run_.end(), plane, style(), 3.5);
            draw_lines(drawing, run_.end(), plane, 1);
        }
        Drawing legend{text_width, legend_height};
        add_horizon_names(legend, words().upper, words().lower, style());
        drawing.place(legend, {plane.shown.x, height_of(plane)});
        page().place(drawing, {margin, y_});
        y_ += drawing.height;
    }

    /// A line on each column that has samples, and on each whole y. Not all have a number where they are close.
    void draw_grid(Drawing& to, const Plane& plane) const {
        constexpr double close = 3.5;  // millimetres
        const int by = plane.scale < close ? 5 : 1;
        const int right = area().right() - 1;
        const double letter = 0.72 * tick_size / points_per_millimetre;
        std::vector<Polyline> lines;
        for (int x = area().x; x <= right; ++x) {
            lines.push_back({plane.at(x, area().y), plane.at(x, area().bottom())});
            if ((x - area().x) % by != 0) continue;
            to.add(
                Label{integer_text(x), {lines.back()[0].x, plane.shown.y - 1}, tick_size, Anchor::middle, false, ink});
        }
        for (int y = area().y; y <= area().bottom(); ++y) {
            lines.push_back({plane.at(area().x, y), plane.at(right, y)});
            if ((y - area().y) % by != 0) continue;
            const Point at{plane.shown.x - 1, lines.back()[0].y + letter / 2};
            to.add(Label{integer_text(y), at, tick_size, Anchor::end, false, ink});
        }
        to.add(Path{std::move(lines), false, {}, Stroke{band}});
    }

    /// The curves, thin, each with its number where it begins.
    void draw_given(Drawing& to, const Plane& plane) const {
        constexpr double apart = 2.8;  // millimetres, between numbers
        struct Beginning {
            Point at;
            int curve;
        };
        std::vector<Beginning> beginnings;
        const auto& curves = run_.scene().curves;
        for (std::size_t curve = 0; curve < curves.size(); ++curve) {
            bool has_begun = false;
            for (const Piece& piece : pieces_of(curves[curve])) {
                Polyline line;
                for (const auto& [x, y] : piece) line.push_back(plane.at(x, y));
                if (!std::exchange(has_begun, true)) beginnings.push_back({line.front(), int(curve)});
                to.add(Path{clipped(line, false, plane.shown), false, {}, Stroke{faint, 0.5}});
            }
        }
        std::stable_sort(beginnings.begin(), beginnings.end(), [](const Beginning& a, const Beginning& b) {
            return a.at.x < b.at.x || (a.at.x == b.at.x && a.at.y < b.at.y);
        });
        Point last{-1, 0};
        for (const auto& [start, curve] : beginnings) {
            Point at{start.x - 1, std::clamp(start.y, plane.shown.y, plane.shown.bottom()) + 1};
            if (at.x == last.x) at.y = std::max(at.y, last.y + apart);
            to.add(Label{std::to_string(curve), at, text_size, Anchor::end, true, ink});
            last = at;
        }
    }

    // --------------------------------------------------------------------------------- the curves

    void add_curves() {
        std::vector<std::uint64_t> steps;
        for (const auto& each : run_.curves()) steps.push_back(each.step);
        const auto [first, end] = chosen_in(steps);
        std::vector<std::string_view> legend{words().flags_legend, words().meets_legend};
        if (has_side_edges()) legend.push_back(words().sides_legend);
        const double foot = double(legend.size()) * line_height;
        add_heading(words().by_columns);
        y_ += heading_height;
        for (std::size_t curve = first > 0 ? first - 1 : 0; curve < end; ++curve) {
            const Form form = form_of(int(curve), curve < first);
            if (y_ + form.height() + foot > text_bottom) {
                for (const auto line : legend) add_note(line);
                add_page();
                add_heading(words().by_columns);
                y_ += heading_height;
            }
            add_form(form, text_width);
            y_ += part_gap / 2;
        }
        y_ -= part_gap / 2;
        for (const auto line : legend) add_note(line);
    }

    /// Whether some columns lie between the ends of two curves, so that a side edge counts there.
    bool has_side_edges() const {
        const auto& curves = run_.scene().curves;
        return std::adjacent_find(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
                   const auto near = pieces_of(a), far = pieces_of(b);
                   return !near.empty() && !far.empty() &&
                          (std::abs(near.front().front().x - far.front().front().x) > 1 ||
                           std::abs(near.back().back().x - far.back().back().x) > 1);
               }) != curves.end();
    }

    Form form_of(int place, bool is_given) const {
        const WorkedCurve& found = run_.curves()[std::size_t(place)];
        const auto& samples = run_.scene().curves[std::size_t(place)].samples;
        Form form{{{std::string(words().curve) + " " + std::to_string(place), name_share}}, {}};
        Row heights{{"y", true}}, flags{{std::string(words().flag), true}};
        Row upper{{std::string(words().upper), true}}, lower{{std::string(words().lower), true}};
        const double share = (1 - name_share) / area().width;
        for (int x = area().x; x < area().right(); ++x) {
            form.columns.push_back({integer_text(x), share});
            const bool is_sample =
                std::any_of(samples.begin(), samples.end(), [&](const Sample& s) { return s.x == x; });
            const auto height = found.heights.find(x);
            const bool is_beside = height == found.heights.end();
            heights.push_back({is_beside ? "" : number(height->second), is_sample || is_given});
            flags.push_back({is_beside ? "" : flag_text(found.flags.at(x)), is_given});
            const auto column = std::size_t(x - area().x);
            for (auto& [row, horizon] : {std::pair(&upper, &found.upper), std::pair(&lower, &found.lower)}) {
                const auto& reached = (*horizon)[column];
                row->push_back({reached ? number(*reached) : "—", is_given});
            }
        }
        Row meets{{std::string(words().meets), true}, {meetings_of(found), is_given}};
        form.rows = {std::move(heights), std::move(flags), std::move(meets), std::move(upper), std::move(lower)};
        return form;
    }

    static std::string flag_text(VisibilityFlag flag) {
        return flag == VisibilityFlag::both ? "±1" : integer_text(int(flag));
    }

    std::string meetings_of(const WorkedCurve& curve) const {
        std::string text;
        for (const auto& [point, upper] : curve.meetings) {
            text += (text.empty() ? "" : ";  ") + std::string(upper ? words().upper : words().lower) + " " +
                    pair_of(number(point.x), number(point.y), language());
        }
        return text.empty() ? "—" : text;
    }

    const WorkedCurves& run_;
};

}  // namespace

void expect_room(const CurveScene& scene, const std::string& file) {
    if (scene.curves.empty()) throw Refused(file + ": curves: there are none");
    expect_at_most(curve_room, scene.curves.size(), "curves", file);
    expect_at_most(column_room, std::size_t(scene.area.width), "columns", file);
    expect_at_most(row_room, std::size_t(scene.area.height), "rows", file);
}

std::vector<Drawing> worksheet(const WorkedCurves& run, Language language, bool answered,
                               const std::optional<ChosenRows>& chosen) {
    return CurveWorksheet(run, language, answered, chosen).pages();
}

}  // namespace vidno::figures
