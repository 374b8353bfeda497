#include <algorithm>

#include "choice/algorithm.h"
#include "notation.h"
#include "parts.h"
#include "refused.h"
#include "table.h"
#include "weiler_atherton_parts.h"

namespace vidno::figures {

namespace {

/// z at two corners of the window.
std::string corner_depths(const WarnockState::CornerDepths& corners, Language language, std::array<Corner, 2> shown) {
    const auto& words = words_of(language);
    constexpr std::size_t two_on_a_line = 10;
    std::string text;
    for (const Corner corner : shown) {
        const auto place = std::size_t(corner);
        text += (text.empty()                    ? ""
                 : language == Language::russian ? "; "
                                                 : ", ") +
                std::string(words.corners[place]) + " " + readable(corners.of[place], language, two_on_a_line);
    }
    return text;
}

Table active_polygons(const Moment& moment, const Style& style) {
    const auto& words = words_of(style.language);
    const State& state = moment.state();
    Table table{.title = std::string(words.active_polygons),
                .columns = {{"P", 0.2}, {std::string(words.surrounds), 0.22}, {std::string(words.nearer_at), 0.58}}};
    if (!state.warnock().current()) {
        table.below.emplace_back(words.empty);
        return table;
    }
    table.below.push_back("U = " + readable(state.warnock().current()->window, style.language) + ", " +
                          std::string(words.stack) + ": " + std::to_string(state.warnock().stack().size()));
    if (state.warnock().last().corners) {
        table.below.push_back(std::string(words.corner_depths) + ":");
        table.below.push_back(corner_depths(*state.warnock().last().corners, style.language,
                                            {Corner::left_bottom, Corner::right_bottom}));
        table.below.push_back(
            corner_depths(*state.warnock().last().corners, style.language, {Corner::left_top, Corner::right_top}));
    }
    const auto current = current_polygon(moment);
    for (const auto& [polygon, surrounds] : state.warnock().list(*state.warnock().current()).entries()) {
        const ScenePolygon& shown = moment.scene().polygons[std::size_t(polygon.index)];
        const auto nearer = moment.nearer_at().find(polygon.index);
        if (current == polygon.index) table.current = table.rows.size();
        table.rows.push_back({{shown.id, tinted(shown.color, style.greyscale)},
                              {std::string(surrounds ? words.yes : words.no)},
                              {nearer == moment.nearer_at().end() ? "" : places_of(nearer->second, words)}});
    }
    return table;
}

/// The edge that the step is about.
std::optional<int> current_edge(const Moment& moment) {
    std::optional<int> edge;
    if (!moment.event()) return edge;
    moment.event()->visit([&](const auto& e) {
        if constexpr (requires { std::optional<int>(e.edge); }) edge = e.edge;
    });
    return edge;
}

/// Draws the list with this width.
Table active_edges(const Moment& moment, const Style& style, double width) {
    constexpr double share = 0.185;  // of a column of numbers, of the width
    constexpr double digit = 1.85;   // with what is around it, millimetres
    const auto room = std::clamp(std::size_t(share * width / style.letters / digit), std::size_t{6}, short_enough);
    const auto& words = words_of(style.language);
    const State& state = moment.state();
    Table table{.title = std::string(words.active_edges),
                .columns = {{std::string(words.edge), 0.145, Anchor::end},
                            {"x", share, Anchor::end},
                            {"z", share, Anchor::end},
                            {std::string(words.until), 0.115, Anchor::end},
                            {"Δx", share, Anchor::end},
                            {"Δz", share, Anchor::end}}};
    if (const auto p = state.z_buffer().polygon())
        table.note = "P = " + moment.scene().polygons[std::size_t(p->index)].id;
    if (const auto& y = state.z_buffer().last().y) table.note += ", yₜ = " + readable(*y, style.language);
    const auto current = current_edge(moment);
    const auto cell = [&](const Value& value, std::size_t most) {
        return Table::Cell{readable(value, style.language, most)};
    };
    for (const auto& entry : state.z_buffer().active_edges()) {
        if (current == entry.edge) table.current = table.rows.size();
        table.rows.push_back({{std::to_string(entry.edge)},
                              cell(entry.x, room),
                              cell(entry.z, room),
                              cell(entry.until, short_enough),
                              cell(entry.dx, room),
                              cell(entry.dz, room)});
    }
    if (state.z_buffer().active_edges().empty()) table.below.emplace_back(words.empty);
    return table;
}

}  // namespace

std::string places_of(const std::vector<Corner>& corners, const FigureWords& words) {
    const auto has = [&](std::size_t corner) {
        return std::find(corners.begin(), corners.end(), Corner(corner)) != corners.end();
    };
    if (corners.size() == words.corners.size()) return std::string(words.all_corners);
    std::string places;
    for (std::size_t i = 0; i < words.corners.size(); ++i) {
        if (corners.size() == words.corners.size() - 1 && !has(i)) return std::string(words.all_but[i]);
        if (has(i)) places += (places.empty() ? "" : ", ") + std::string(words.corners[i]);
    }
    return places.empty() ? "—" : places;
}

Drawing list_part(const Moment& moment, const Style& style, double width) {
    const TraceHeader& header = moment.header();
    if (header.detail < Detail::polygons) {
        throw Refused("list: a trace at level windows has no APL and no AEL");
    }
    Table table;
    switch (algorithm_of(header.method)) {
        case Algorithm::warnock: table = active_polygons(moment, style); break;
        case Algorithm::z_buffer: table = active_edges(moment, style, width); break;
        case Algorithm::weiler_atherton: return region_list(moment, style, width);
    }
    shorten(table, words_of(style.language));
    return drawn(table, width, style.letters);
}

}  // namespace vidno::figures
