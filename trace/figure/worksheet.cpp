#include "worksheet.h"

#include <cmath>

#include "choice/algorithm.h"
#include "choice/method.h"
#include "form.h"
#include "notation.h"
#include "parts.h"
#include "refused.h"
#include "stability/shrink.h"
#include "table.h"
#include "titles.h"
#include "weiler_atherton_parts.h"
#include "worksheet_words.h"

namespace vidno::figures {

namespace {

constexpr double page_width = 210, page_height = 297, margin = 18;
constexpr double text_width = page_width - 2 * margin, text_bottom = page_height - margin;
constexpr double part_gap = 5, heading_height = 7, title_size = 11;
constexpr double half_width = (text_width - part_gap) / 2;
constexpr double vertex_row_height = 4.8;

constexpr std::size_t most_pages_of_rows = 2;
constexpr std::size_t most_polygons = 10, most_vertices = 45;
constexpr int longest_side = 40;
constexpr double room_for_depth = 8;  // millimetres a pixel

/// The pages so far, and how much of the last one is filled.
class Worksheet {
public:
    Worksheet(const WorkedRun& run, Language language, bool answered, const std::optional<ChosenRows>& chosen)
        : run_(run), style_{language}, words_(worksheet_words_of(language)), answered_(answered), chosen_(chosen) {}

    std::vector<Drawing> pages() && {
        add_page();
        add_scene();
        add_page();
        switch (algorithm_of(run_.header().method)) {
            case Algorithm::warnock:
                add_quadtree();
                add_windows();
                break;
            case Algorithm::z_buffer:
                add_rows();
                add_page();
                add_raster();
                break;
            case Algorithm::weiler_atherton:
                add_regions();
                add_lists();
                break;
        }
        return std::move(pages_);
    }

private:
    using Row = std::vector<Form::Cell>;
    struct StepRow {
        std::uint64_t step;
        Row row;
    };

    Drawing& page() { return pages_.back(); }
    const Scene& scene() const { return run_.scene(); }
    const std::string& name_of(int polygon) const { return scene().polygons[std::size_t(polygon)].id; }

    void put(std::string text, Point at, double size, Anchor anchor = Anchor::start, bool bold = false) {
        page().add(Label{std::move(text), at, size, anchor, bold, ink});
    }
    void rule(double from, double to, double y, double width) {
        page().add(Path{{{{from, y}, {to, y}}}, false, {}, Stroke{ink, width}});
    }

    void add_page() {
        pages_.push_back({page_width, page_height});
        const double right = page_width - margin;
        double y = margin;
        const std::string method = title_of(run_.header().method, style_.language);
        const double room = text_width - width_of(method, text_size) - part_gap;
        put(fitted(name_in(style_.language, scene().name), room, title_size, true), {margin, y}, title_size,
            Anchor::start, true);
        put(method, {right, y}, text_size, Anchor::end);
        y += 2;
        rule(margin, right, y, 0.75);
        y += 8;
        if (answered_) {
            put(std::string(words_.key), {margin, y}, title_size, Anchor::start, true);
        } else {
            add_line_for(words_.name, margin, margin + 0.68 * text_width, y);
            add_line_for(words_.date, margin + 0.68 * text_width + part_gap, right, y);
        }
        const std::string number = std::string(words_.page) + " " + std::to_string(pages_.size());
        put(number, {right, page_height - margin / 2}, small_size, Anchor::end);
        y_ = y + 4;
    }

    void add_line_for(std::string_view what, double from, double to, double y) {
        const std::string text(what);
        put(text, {from, y}, text_size);
        rule(from + width_of(text, text_size) + 1.5, to, y + 0.5, Stroke::hairline);
    }

    void add_heading(std::string_view text, double x) {
        put(std::string(text), {x, y_ + heading_height - 2}, 9, Anchor::start, true);
    }

    void add_note(std::string_view text) {
        y_ += line_height;
        put(fitted(std::string(text), text_width, small_size), {margin, y_}, small_size);
    }

    // --------------------------------------------------------------------------------- the scene

    void add_scene() {
        add_heading(words_.scene, margin);
        add_heading(words_.vertices, margin + half_width + part_gap);
        y_ += heading_height;
        page().place(drawn(vertices(), half_width, answered_), {margin + half_width + part_gap, y_});
        const Plane plane = plane_in(scene().area, half_width, half_width * 1.1);
        Drawing drawing{half_width, height_of(plane)};
        draw_picture(drawing, run_.start(), plane, style_);
        draw_scene(drawing, plane);
        draw_names(drawing, scene(), plane, style_);
        page().place(drawing, {margin, y_});
        y_ += drawing.height + part_gap;
        put(fitted(std::string(words_.depth_rule), half_width, small_size), {margin, y_}, small_size);
        y_ += part_gap / 2;
        add_heading(words_.planes, margin);
        y_ += heading_height;
        const Form form = planes();
        page().place(drawn(form, half_width, answered_), {margin, y_});
        y_ += form.height();
        add_note(words_.factor);
    }

    void draw_scene(Drawing& to, const Plane& plane) const {
        draw_frame(to, plane);
        draw_outlines(to, run_.start(), plane, style_);
    }

    Form vertices() const {
        Form form{{{"P", 0.16}, {"x", 0.25}, {"y", 0.25}, {"z", 0.34}}, {}, vertex_row_height};
        for (const auto& polygon : scene().polygons) {
            std::string name = polygon.id;
            for (const auto& vertex : polygon.vertices) {
                form.rows.push_back({{std::exchange(name, ""), true},
                                     {in_full(vertex.x), true},
                                     {in_full(vertex.y), true},
                                     {in_full(vertex.z), true}});
            }
        }
        return form;
    }

    Form planes() const {
        Form form{{{"P", 0.16}, {"a", 0.21}, {"b", 0.21}, {"c", 0.21}, {"d", 0.21}}, {}};
        for (const auto& [polygon, plane] : run_.planes()) {
            Row row{{name_of(polygon), true}};
            for (const Value& value : plane) row.push_back({readable(value)});
            form.rows.push_back(std::move(row));
        }
        return form;
    }

    // --------------------------------------------------------------------------------- Warnock

    void add_quadtree() {
        constexpr double width = 118;
        add_heading(words_.quadtree, margin);
        y_ += heading_height;
        const Plane plane = plane_in(scene().area, width, width);
        Drawing drawing{width, height_of(plane)};
        draw_picture(drawing, answered_ ? run_.end() : run_.start(), plane, style_);
        draw_scene(drawing, plane);
        if (answered_) draw_visited(drawing, run_.end(), plane);
        draw_names(drawing, scene(), plane, style_);
        page().place(drawing, {margin + (text_width - width) / 2, y_});
        y_ += drawing.height;
    }

    void add_windows() {
        constexpr double number = 0.06, window = 0.2, decision = 0.17, painted = 0.09;
        const double share = (1 - number - window - decision - painted) / double(scene().polygons.size());
        std::vector<Form::Column> columns{{std::string(words_.number), number}, {std::string(words_.window), window}};
        for (const auto& polygon : scene().polygons) columns.push_back({polygon.id, share});
        columns.push_back({std::string(words_.decision), decision});
        columns.push_back({std::string(words_.painted), painted});
        std::vector<StepRow> rows;
        for (const auto& each : run_.windows()) rows.push_back({each.step, row_of(each)});
        const bool family = is_family(run_.header().method);
        add_rows(words_.windows, columns, std::move(rows),
                 {family ? words_.family_legend : words_.legend, family ? words_.family_decisions : words_.decisions},
                 {.are_numbered = true, .places = 1});
    }

    Row row_of(const WorkedWindow& window) const {
        const bool has_relations = is_family(run_.header().method);
        Row row{{readable(window.window)}};
        for (int i = 0; i < int(scene().polygons.size()); ++i) {
            const auto entry = window.entries.find(i);
            const bool is_known = entry != window.entries.end() && (!has_relations || entry->second.relation);
            row.push_back({is_known ? text_of(entry->second) : ""});
        }
        const auto& label = line_names[std::size_t(window.line)];
        row.push_back({std::string(label) + " " + std::string(words_.cases[std::size_t(window.which)])});
        const std::string shown = window.painted ? name_of(*window.painted) : std::string(words_.background);
        row.push_back({window.which == Case::split ? "" : shown});
        return row;
    }

    static std::string text_of(const WorkedEntry& entry) {
        static constexpr std::array<std::string_view, relation_names.size()> signs{"−", "I", "+", "S"};
        if (entry.relation) return std::string(signs[std::size_t(*entry.relation)]);
        if (entry.leaves) return "−";
        return (entry.surrounds ? "S " : "+ ") + std::to_string(entry.k);
    }

    // --------------------------------------------------------------------------------- Weiler-Atherton

    void add_regions() {
        constexpr double width = 118;
        add_heading(words_.regions, margin);
        y_ += heading_height;
        const Plane plane = plane_in(scene().area, width, width);
        Drawing drawing{width, height_of(plane)};
        if (answered_) draw_visible(drawing, run_.end(), plane, style_);
        draw_scene(drawing, plane);
        draw_names(drawing, scene(), plane, style_);
        page().place(drawing, {margin + (text_width - width) / 2, y_});
        y_ += drawing.height;
    }

    void add_lists() {
        const std::vector<Form::Column> columns{{std::string(words_.number), 0.06},  {std::string(words_.clip), 0.08},
                                                {std::string(words_.list), 0.2},     {std::string(words_.inside), 0.18},
                                                {std::string(words_.outside), 0.18}, {std::string(words_.nearer), 0.16},
                                                {std::string(words_.result), 0.14}};
        std::vector<StepRow> rows;
        for (const auto& each : run_.lists()) rows.push_back({each.step, row_of(each)});
        add_rows(words_.lists, columns, std::move(rows), {words_.lists_legend}, {.are_numbered = true, .places = 2});
    }

    Row row_of(const WorkedList& list) const {
        const auto names = [&](const std::vector<int>& polygons) {
            std::string text;
            for (const int polygon : polygons) text += (text.empty() ? "" : ", ") + name_of(polygon);
            return text.empty() ? "∅" : text;
        };
        return {{name_of(list.polygons.front())},
                {names(list.polygons)},
                {names(list.inside)},
                {names(list.outside)},
                {names(list.nearer)},
                {std::string(list.visible ? words_.visible : words_.again)}};
    }

    // --------------------------------------------------------------------------------- Z-buffer

    void add_rows() {
        std::vector<Form::Column> columns{{"P", 0.07}, {std::string(words_.row), 0.07}};
        for (const std::string edge : {"₁", "₂"}) {
            for (const std::string part : {"x", "z", "y", "Δx", "Δz"}) {
                columns.push_back({part + edge, part == "y" ? 0.055 : 0.086});
            }
        }
        columns.push_back({std::string(words_.pixels), 0.062});
        std::vector<StepRow> rows;
        for (const auto& each : run_.rows()) rows.push_back({each.step, row_of(each)});
        add_rows(words_.edges, columns, std::move(rows), {words_.edges_legend}, {.are_numbered = false, .places = 2});
    }

    Row row_of(const WorkedRow& shown) const {
        Row row{{name_of(shown.polygon)}, {std::to_string(shown.row)}};
        for (std::size_t i = 0; i < 2; ++i) {
            if (i >= shown.edges.size()) {
                row.insert(row.end(), 5, {"—"});
                continue;
            }
            const auto& [edge, x, z, until, dx, dz] = shown.edges[i];
            for (const Value& value : {x, z, until, dx, dz}) row.push_back({readable(value)});
        }
        const std::string pixels = std::to_string(shown.first) + "–" + std::to_string(shown.end - 1);
        row.push_back({shown.first < shown.end ? pixels : "—"});
        return row;
    }

    void add_raster() {
        const Area& area = scene().area;
        constexpr double ticks = 5;
        const double room = text_bottom - y_ - heading_height - ticks;
        const double side = std::min((text_width - ticks) / area.width, room / area.height);
        const bool has_depths = side >= room_for_depth;
        add_heading(has_depths ? words_.raster : words_.raster_of_names, margin);
        y_ += heading_height;
        const Point origin{margin + ticks, y_ + ticks};
        std::vector<Polyline> lines;
        const double right = origin.x + side * area.width, bottom = origin.y + side * area.height;
        for (int i = 1; i < area.width; ++i) {
            lines.push_back({{origin.x + i * side, origin.y}, {origin.x + i * side, bottom}});
        }
        for (int j = 1; j < area.height; ++j) {
            lines.push_back({{origin.x, origin.y + j * side}, {right, origin.y + j * side}});
        }
        const double letter = 0.72 * small_size / points_per_millimetre;
        for (int i = 0; i < area.width; ++i) {
            put(tick_text(area.x + i), {origin.x + (i + 0.5) * side, origin.y - 1}, tick_size_in(side), Anchor::middle);
        }
        for (int j = 0; j < area.height; ++j) {
            const double base = origin.y + (j + 0.5) * side + letter / 2;
            put(tick_text(area.y + j), {origin.x - 1, base}, tick_size_in(side), Anchor::end);
        }
        for (int j = 0; answered_ && j < area.height; ++j) {
            for (int i = 0; i < area.width; ++i) {
                add_pixel(area.x + i, area.y + j, {origin.x + i * side, origin.y + j * side, side, side}, has_depths);
            }
        }
        page().add(Path{std::move(lines), false, {}, Stroke{faint}});
        page().add(rectangle({origin.x, origin.y, right - origin.x, bottom - origin.y}, {}, Stroke{ink, 0.5}));
    }

    static double tick_size_in(double side) { return side < 5 ? 5 : small_size; }

    void add_pixel(int x, int y, const Box& box, bool has_depth) {
        const double depth_size = std::min(6.5, 0.65 * box.width);
        const auto polygon = run_.shown(x, y);
        if (!polygon) return;
        page().add(rectangle(box, tinted(scene().polygons[std::size_t(*polygon)].color, style_.greyscale)));
        const double middle = box.x + box.width / 2;
        const double base = box.y + box.height * (has_depth ? 0.42 : 0.68);
        put(fitted(name_of(*polygon), box.width - 0.4, small_size, true), {middle, base}, small_size, Anchor::middle,
            true);
        if (!has_depth) return;
        const std::string depth = readable(*run_.end().state().depth(x, y));
        put(fitted(depth, box.width - 0.4, depth_size), {middle, box.bottom() - box.height * 0.18}, depth_size,
            Anchor::middle);
    }

    // --------------------------------------------------------------------------------- long tables

    struct Numbering {
        bool are_numbered;
        std::size_t places;  // how many of the first columns say where a row is
    };

    /// The rows that are answered, as a range of places in all of them.
    std::pair<std::size_t, std::size_t> chosen_in(const std::vector<StepRow>& rows) const {
        if (!chosen_) return {0, rows.size()};
        const auto is_chosen = [&](std::size_t place) {
            const std::uint64_t number = chosen_->are_steps ? rows[place].step : place + 1;
            return chosen_->first <= number && number <= chosen_->last;
        };
        std::size_t first = 0;
        while (first < rows.size() && !is_chosen(first)) ++first;
        std::size_t end = first;
        while (end < rows.size() && is_chosen(end)) ++end;
        if (first == end)
            throw Refused("--" + std::string(chosen_->are_steps ? "steps" : "rows") + ": " + scene().name +
                          " has no such row; rows in all: " + std::to_string(rows.size()));
        return {first, end};
    }

    /// Adds rows to the end of the page, whether they have answers or not, so that their number gives no hint, unless rows are chosen.
    void add_rows(std::string_view title, const std::vector<Form::Column>& columns, std::vector<StepRow> answers,
                  const std::vector<std::string_view>& legend, const Numbering& numbering) {
        const auto [first, end] = chosen_in(answers);
        if (first > 0) {
            for (auto& cell : answers[first - 1].row) cell.is_given = true;
            for (std::size_t i = first; i < end; ++i) {
                for (std::size_t place = 0; place < numbering.places; ++place) answers[i].row[place].is_given = true;
            }
        }
        std::size_t done = first > 0 ? first - 1 : 0;
        for (std::size_t pages = 0; pages == 0 || (done < end && (chosen_ || pages < most_pages_of_rows)); ++pages) {
            if (pages > 0) add_page();
            add_heading(title, margin);
            y_ += heading_height;
            Form form{columns, {}};
            const double room = text_bottom - y_ - Form::heading_height - double(legend.size() + 1) * line_height;
            for (auto left = std::size_t(room / form.row_height); left > 0 && (!chosen_ || done < end);
                 --left, ++done) {
                Row row = done < end ? std::move(answers[done].row) : Row(columns.size() - numbering.are_numbered);
                if (numbering.are_numbered) row.insert(row.begin(), {std::to_string(done + 1), true});
                form.rows.push_back(std::move(row));
            }
            page().place(drawn(form, text_width, answered_), {margin, y_});
            y_ += form.height() + 0.6;
            for (const auto line : legend) add_note(line);
        }
        if (done < answers.size()) add_note(std::string(words_.rows_here) + " " + std::to_string(done) + ".");
    }

    const WorkedRun& run_;
    Style style_;
    const WorksheetWords& words_;
    bool answered_;
    std::optional<ChosenRows> chosen_;
    std::vector<Drawing> pages_;
    double y_ = 0;
};

}  // namespace

void expect_room(const Scene& scene, const std::string& file) {
    const auto expect = [&](std::size_t count, std::size_t most, const char* what) {
        if (count <= most) return;
        throw Refused(file + ": " + std::to_string(count) + " " + what + ", a worksheet has room for " +
                      std::to_string(most));
    };
    if (scene.polygons.empty()) throw Refused(file + ": polygons: there are none");
    expect(scene.polygons.size(), most_polygons, "polygons");
    expect(vertices_of(scene), most_vertices, "vertices");
    expect(std::size_t(std::max(scene.area.width, scene.area.height)), longest_side, "pixels a side");
}

std::vector<Drawing> worksheet(const WorkedRun& run, Language language, bool answered,
                               const std::optional<ChosenRows>& chosen) {
    return Worksheet(run, language, answered, chosen).pages();
}

}  // namespace vidno::figures
