#include <algorithm>

#include "choice/algorithm.h"
#include "notation.h"
#include "parts.h"
#include "refused.h"
#include "table.h"
#include "weiler_atherton_parts.h"

namespace vidno::figures {

namespace {

std::string places_of(const std::vector<Corner>& corners) {
    std::string places;
    for (const Corner corner : corners) {
        places += (places.empty() ? "" : ", ") + std::string(corner_names[std::size_t(corner)]);
    }
    return places.empty() ? "—" : places;
}

/// z at the corners of the window.
std::string corner_depths(const std::array<Value, 4>& corners) {
    constexpr std::size_t four_on_a_line = 6;
    std::string text;
    for (std::size_t i = 0; i < corner_names.size(); ++i) {
        text += (i == 0 ? "" : ", ") + std::string(corner_names[i]) + " " + readable(corners[i], four_on_a_line);
    }
    return text;
}

Table active_polygons(const Moment& moment, const Style& style) {
    const auto& words = words_of(style.language);
    const State& state = moment.state();
    Table table{.title = std::string(words.active_polygons),
                .columns = {{"P", 0.28}, {std::string(words.surrounds), 0.3}, {std::string(words.nearer_at), 0.42}}};
    if (!state.current()) {
        table.below.emplace_back(words.empty);
        return table;
    }
    table.below.push_back("U = " + readable(state.current()->window) + ", " + std::string(words.stack) + ": " +
                          std::to_string(state.stack().size()));
    if (state.corners()) {
        table.below.push_back(std::string(words.corner_depths) + ":");
        table.below.push_back(corner_depths(*state.corners()));
    }
    const auto in_hand = polygon_in_hand(moment);
    for (const auto& [polygon, surrounds] : *state.current()->apl) {
        const auto& [id, color, vertices, edge_on] = moment.scene().polygons[std::size_t(polygon.index)];
        const auto nearer = moment.nearer_at().find(polygon.index);
        if (in_hand == polygon.index) table.current = table.rows.size();
        table.rows.push_back({{id, tinted(color, style.greyscale)},
                              {std::string(surrounds ? words.yes : words.no)},
                              {nearer == moment.nearer_at().end() ? "" : places_of(nearer->second)}});
    }
    return table;
}

/// The edge that the step is about.
std::optional<int> edge_in_hand(const Moment& moment) {
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
    if (state.polygon()) table.note = "P = " + moment.scene().polygons[std::size_t(*state.polygon())].id;
    if (state.y()) table.note += ", yₜ = " + readable(*state.y());
    const auto in_hand = edge_in_hand(moment);
    for (const auto& entry : state.ael()) {
        if (in_hand == entry.edge) table.current = table.rows.size();
        table.rows.push_back({{std::to_string(entry.edge)},
                              {readable(entry.x, room)},
                              {readable(entry.z, room)},
                              {readable(entry.until)},
                              {readable(entry.dx, room)},
                              {readable(entry.dz, room)}});
    }
    if (state.ael().empty()) table.below.emplace_back(words.empty);
    return table;
}

}  // namespace

Drawing list_part(const Moment& moment, const Style& style, double width) {
    const TraceHeader& header = moment.header();
    if (header.detail < Detail::polygons) {
        throw Refused("list: a trace of level windows tells no APL and no AEL");
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
