#include "worksheet.h"

#include <cmath>

#include "choice/algorithm.h"
#include "choice/method.h"
#include "notation.h"
#include "refused.h"
#include "sheet.h"
#include "stability/shrink.h"
#include "table.h"
#include "titles.h"
#include "weiler_atherton_parts.h"

namespace vidno::figures {

namespace {

constexpr double vertex_row_height = 4.8;

constexpr std::size_t most_polygons = 10, most_vertices = 45;
constexpr int longest_side = 40;
constexpr double room_for_depth = 8;  // millimetres a pixel

class Worksheet : Sheet {
public:
    Worksheet(const WorkedRun& run, Language language, bool answered, const std::optional<ChosenRows>& chosen)
        : Sheet(run.scene().name, title_of(run.header().method, language), language, answered, chosen), run_(run) {}

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
                add_spans();
                add_page();
                add_raster();
                break;
            case Algorithm::weiler_atherton:
                add_regions();
                add_lists();
                break;
        }
        return taken_pages();
    }

private:
    static constexpr double half_width = (text_width - part_gap) / 2;

    const Scene& scene() const { return run_.scene(); }
    const std::string& name_of(int polygon) const { return scene().polygons[std::size_t(polygon)].id; }

    // --------------------------------------------------------------------------------- the scene

    void add_scene() {
        add_heading(words().scene);
        add_heading(words().vertices, margin + half_width + part_gap);
        y_ += heading_height;
        page().place(drawn(vertices(), half_width, is_answered()), {margin + half_width + part_gap, y_});
        const Plane plane = plane_in(scene().area, half_width, half_width * 1.1);
        Drawing drawing{half_width, height_of(plane)};
        draw_picture(drawing, run_.start(), plane, style());
        draw_scene(drawing, plane);
        draw_names(drawing, scene(), plane, style());
        page().place(drawing, {margin, y_});
        y_ += drawing.height + part_gap;
        put(fitted(std::string(words().depth_rule), half_width, small_size), {margin, y_}, small_size);
        y_ += part_gap / 2;
        add_heading(words().planes);
        y_ += heading_height;
        const Form form = planes();
        add_form(form, half_width);
        add_note(words().factor);
    }

    void draw_scene(Drawing& to, const Plane& plane) const {
        draw_frame(to, plane);
        draw_outlines(to, run_.start(), plane, style());
    }

    Form vertices() const {
        Form form{{{"P", 0.16}, {"x", 0.25}, {"y", 0.25}, {"z", 0.34}}, {}, vertex_row_height};
        for (const auto& polygon : scene().polygons) {
            std::string name = polygon.id;
            for (const auto& vertex : polygon.vertices) {
                form.rows.push_back({{std::exchange(name, ""), true},
                                     {in_full(vertex.x, language()), true},
                                     {in_full(vertex.y, language()), true},
                                     {in_full(vertex.z, language()), true}});
            }
        }
        return form;
    }

    Form planes() const {
        Form form{{{"P", 0.16}, {"a", 0.21}, {"b", 0.21}, {"c", 0.21}, {"d", 0.21}}, {}};
        for (const auto& [polygon, plane] : run_.planes()) {
            Row row{{name_of(polygon), true}};
            for (const Value& value : plane) row.push_back({readable(value, language())});
            form.rows.push_back(std::move(row));
        }
        return form;
    }

    // --------------------------------------------------------------------------------- Warnock

    void add_quadtree() {
        constexpr double width = 118;
        add_heading(words().quadtree);
        y_ += heading_height;
        const Plane plane = plane_in(scene().area, width, width);
        Drawing drawing{width, height_of(plane)};
        draw_picture(drawing, is_answered() ? run_.end() : run_.start(), plane, style());
        draw_scene(drawing, plane);
        if (is_answered()) draw_visited(drawing, run_.end(), plane);
        draw_names(drawing, scene(), plane, style());
        page().place(drawing, {margin + (text_width - width) / 2, y_});
        y_ += drawing.height;
    }

    void add_windows() {
        constexpr double number = 0.06, window = 0.2, decision = 0.17, painted = 0.09;
        const double share = (1 - number - window - decision - painted) / double(scene().polygons.size());
        std::vector<Form::Column> columns{{std::string(words().number), number}, {std::string(words().window), window}};
        for (const auto& polygon : scene().polygons) columns.push_back({polygon.id, share});
        columns.push_back({std::string(words().decision), decision});
        columns.push_back({std::string(words().painted), painted});
        std::vector<StepRow> rows;
        for (const auto& each : run_.windows()) rows.push_back({each.step, row_of(each)});
        const bool family = run_.has_relations();
        add_rows(
            words().windows, columns, std::move(rows),
            {family ? words().family_legend : words().legend, family ? words().family_decisions : words().decisions},
            {.are_numbered = true, .places = 1});
    }

    Row row_of(const WorkedWindow& window) const {
        Row row{{readable(window.window, language())}};
        for (int i = 0; i < int(scene().polygons.size()); ++i) {
            const auto entry = window.entries.find(i);
            const bool is_known = entry != window.entries.end() && (!run_.has_relations() || entry->second.relation);
            row.push_back({is_known ? text_of(entry->second) : ""});
        }
        const auto& label = line_names[std::size_t(window.line)];
        row.push_back({std::string(label) + " " + std::string(words_of(language()).cases[std::size_t(window.which)])});
        const std::string shown = window.painted ? name_of(*window.painted) : std::string(words().background);
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
        add_heading(words().regions);
        y_ += heading_height;
        const Plane plane = plane_in(scene().area, width, width);
        Drawing drawing{width, height_of(plane)};
        if (is_answered()) draw_visible(drawing, run_.end(), plane, style());
        draw_scene(drawing, plane);
        draw_names(drawing, scene(), plane, style());
        page().place(drawing, {margin + (text_width - width) / 2, y_});
        y_ += drawing.height;
    }

    void add_lists() {
        const std::vector<Form::Column> columns{
            {std::string(words().number), 0.06},  {std::string(words().clip), 0.08},
            {std::string(words().list), 0.2},     {std::string(words().inside), 0.18},
            {std::string(words().outside), 0.18}, {std::string(words().nearer), 0.16},
            {std::string(words().result), 0.14}};
        std::vector<StepRow> rows;
        for (const auto& each : run_.lists()) rows.push_back({each.step, row_of(each)});
        add_rows(words().lists, columns, std::move(rows), {words().lists_legend}, {.are_numbered = true, .places = 2});
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
                {std::string(list.visible ? words().visible : words().again)}};
    }

    // --------------------------------------------------------------------------------- Z-buffer

    void add_spans() {
        std::vector<Form::Column> columns{{"P", 0.07}, {std::string(words().row), 0.07}};
        for (const std::string edge : {"₁", "₂"}) {
            for (const std::string part : {"x", "z", "y", "Δx", "Δz"}) {
                columns.push_back({part + edge, part == "y" ? 0.055 : 0.086});
            }
        }
        columns.push_back({std::string(words().pixels), 0.062});
        std::vector<StepRow> rows;
        for (const auto& each : run_.rows()) rows.push_back({each.step, row_of(each)});
        add_rows(words().edges, columns, std::move(rows), {words().edges_legend}, {.are_numbered = false, .places = 2});
    }

    Row row_of(const WorkedRow& shown) const {
        Row row{{name_of(shown.polygon)}, {std::to_string(shown.row)}};
        for (std::size_t i = 0; i < 2; ++i) {
            if (i >= shown.edges.size()) {
                row.insert(row.end(), 5, {"—"});
                continue;
            }
            const auto& [edge, x, z, until, dx, dz] = shown.edges[i];
            for (const Value& value : {x, z, until, dx, dz}) row.push_back({readable(value, language())});
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
        add_heading(has_depths ? words().raster : words().raster_of_names);
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
            put(integer_text(area.x + i), {origin.x + (i + 0.5) * side, origin.y - 1}, tick_size_in(side),
                Anchor::middle);
        }
        for (int j = 0; j < area.height; ++j) {
            const double base = origin.y + (j + 0.5) * side + letter / 2;
            put(integer_text(area.y + j), {origin.x - 1, base}, tick_size_in(side), Anchor::end);
        }
        for (int j = 0; is_answered() && j < area.height; ++j) {
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
        page().add(rectangle(box, tinted(scene().polygons[std::size_t(*polygon)].color, style().greyscale)));
        const double middle = box.x + box.width / 2;
        const double base = box.y + box.height * (has_depth ? 0.42 : 0.68);
        put(fitted(name_of(*polygon), box.width - 0.4, small_size, true), {middle, base}, small_size, Anchor::middle,
            true);
        if (!has_depth) return;
        const std::string depth = readable(run_.end().state().screen().depths()->at(x, y), language());
        put(fitted(depth, box.width - 0.4, depth_size), {middle, box.bottom() - box.height * 0.18}, depth_size,
            Anchor::middle);
    }

    const WorkedRun& run_;
};

}  // namespace

void expect_room(const Scene& scene, const std::string& file) {
    if (scene.polygons.empty()) throw Refused(file + ": polygons: there are none");
    expect_at_most(most_polygons, scene.polygons.size(), "polygons", file);
    expect_at_most(most_vertices, vertices_of(scene), "vertices", file);
    expect_at_most(longest_side, std::size_t(std::max(scene.area.width, scene.area.height)), "pixels a side", file);
}

std::vector<Drawing> worksheet(const WorkedRun& run, Language language, bool answered,
                               const std::optional<ChosenRows>& chosen) {
    return Worksheet(run, language, answered, chosen).pages();
}

}  // namespace vidno::figures
