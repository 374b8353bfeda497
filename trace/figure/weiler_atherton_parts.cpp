#include "weiler_atherton_parts.h"

#include <cmath>

#include "notation.h"
#include "table.h"

namespace vidno::figures {

namespace {

const ScenePolygon& polygon_of(const Scene& scene, PolygonPlace place) {
    return scene.polygons[std::size_t(place.index)];
}

Path filled(const RegionLoops& region, const Color& color, const Plane& plane, const Style& style) {
    return {loops_of(region, plane), true, tinted(color, style.greyscale), Stroke{ink}};
}

std::string names_of(const WeilerAthertonState::Pieces& parts, const Scene& scene) {
    std::string names;
    for (const auto& part : parts) names += (names.empty() ? "" : ", ") + polygon_of(scene, part->polygon).id;
    return names.empty() ? "∅" : names;
}

/// Says what the points on the plane mean, in a last line.
void add_points_legend(Drawing& to, const Style& style) {
    constexpr double side = 1.2, gap = 1.2;
    const auto& words = words_of(style.language);
    double x = 0;
    to.height += line_height;
    const double base = to.height - 1;
    for (const auto& [text, fill] : {std::pair(words.enters, ink), std::pair(words.leaves, paper)}) {
        to.add(Path{{circle({x + side / 2, base - side / 2}, side / 2)}, true, fill, Stroke{ink, 0.75}});
        x += side + gap;
        to.add(Label{std::string(text), {x, base}, small_size, Anchor::start, false, ink});
        x += width_of(text, small_size) * style.letters + 3 * gap;
    }
}

}  // namespace

std::vector<Polyline> loops_of(const RegionLoops& region, const Plane& plane) {
    std::vector<Polyline> lines;
    for (const auto& loop : region) {
        auto& line = lines.emplace_back();
        for (const auto& [x, y] : loop) {
            const Point at = plane.at(number_of(x), number_of(y));
            if (!std::isfinite(at.x) || !std::isfinite(at.y)) return {};
            line.push_back(at);
        }
    }
    return lines;
}

static std::vector<Polyline> lines_of(const std::vector<LinePiece>& pieces, const Plane& plane) {
    std::vector<Polyline> lines;
    for (const auto& [from, to] : pieces) lines.push_back({plane.at(from[0], from[1]), plane.at(to[0], to[1])});
    return lines;
}

Drawing drawn_regions(const std::vector<ShownRegion>& regions, const Scene& scene) {
    const Plane plane = plane_without_frame(scene.area);
    Drawing drawing{plane.shown.width, plane.shown.height};
    drawing.add(rectangle(plane.shown, scene.background));
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const ScenePolygon& polygon = polygon_of(scene, regions[i].polygon);
        const bool is_part = !polygon.face.empty();
        const Stroke border = is_part ? Stroke{polygon.color, Stroke::hairline} : Stroke{ink};
        drawing.add(Path{loops_of(regions[i].loops, plane), true, polygon.color, border});
        if (is_part) drawing.add(Path{lines_of(border_of(regions, i, scene), plane), false, {}, Stroke{ink}});
    }
    return drawing;
}

Drawing drawn_lines(const SceneLines& lines, HiddenLines hidden, const Scene& scene) {
    const Plane plane = plane_without_frame(scene.area);
    Drawing drawing{plane.shown.width, plane.shown.height};
    const auto add = [&](const std::vector<LinePiece>& pieces, Stroke stroke) {
        drawing.add(Path{lines_of(pieces, plane), false, {}, std::move(stroke)});
    };
    if (hidden == HiddenLines::dashed) add(lines.hidden, {ink, Stroke::hairline, {3, 2}});
    add(lines.visible, {ink, 0.8});
    return drawing;
}

void draw_visible(Drawing& to, const Moment& moment, const Plane& plane, const Style& style) {
    for (const auto& piece : moment.state().weiler_atherton().visible()) {
        to.add(filled(piece->region, polygon_of(moment.scene(), piece->polygon).color, plane, style));
    }
}

void draw_lists(Drawing& to, const Moment& moment, const Plane& plane, const Style& style) {
    const WeilerAthertonState& state = moment.state().weiler_atherton();
    const auto outline = [&](const PolygonPart& part, double width, std::vector<double> dashes) {
        const Color color = deep(polygon_of(moment.scene(), part.polygon).color, style.greyscale);
        to.add(Path{loops_of(part.region, plane), true, {}, Stroke{color, width, std::move(dashes)}});
    };
    for (const auto& list : state.lists()) {
        for (const auto& part : list) outline(*part, 0.4, {0.8, 1.4});
    }
    const auto& current = state.current_list();
    if (!current) return;
    for (const auto& part : current->outside) outline(*part, 0.8, {3, 1.5});
    for (const auto& part : current->inside) outline(*part, 0.8, {});
    add_rimmed(to, Path{loops_of(current->pieces.front()->region, plane), true, {}, Stroke{ink, 1}});
}

Drawing region_list(const Moment& moment, const Style& style, double width) {
    const auto& words = words_of(style.language);
    const WeilerAthertonState& state = moment.state().weiler_atherton();
    Table table{.title = std::string(words.current_list),
                .columns = {{"P", 0.4},
                            {std::string(words.vertices), 0.3, Anchor::end},
                            {std::string(words.behind_all), 0.3, Anchor::end}}};
    const std::string stack = std::string(words.stack) + ": " + std::to_string(state.lists().size());
    const auto& current = state.current_list();
    if (!current) {
        table.below = {std::string(words.empty), stack};
        return drawn(table, width, style.letters);
    }
    for (const auto& piece : current->pieces) {
        const auto& [polygon, region, ground] = *piece;
        std::size_t vertices = 0;
        for (const auto& loop : region) vertices += loop.size();
        const auto& source = polygon_of(moment.scene(), polygon);
        table.rows.push_back({{source.id, tinted(source.color, style.greyscale)},
                              {std::to_string(vertices)},
                              {std::string(ground ? words.yes : words.no)}});
    }
    table.current = 0;  // the clip polygon
    table.below = {std::string(words.inside) + ": " + names_of(current->inside, moment.scene()),
                   std::string(words.outside) + ": " + names_of(current->outside, moment.scene()), stack};
    shorten(table, words);
    Drawing drawing = drawn(table, width, style.letters);
    if (!moment.entering().empty()) add_points_legend(drawing, style);
    return drawing;
}

}  // namespace vidno::figures
