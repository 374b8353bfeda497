#include "proof/why.h"

namespace vidno {

namespace {

/// "3/16", or "3" for 3/1.
std::string as_written(const Fraction& fraction) {
    const std::string& text = fraction.text;
    return text.ends_with("/1") ? text.substr(0, text.size() - 2) : text;
}

std::string id_of(int polygon, const Scene& scene) { return scene.polygons[std::size_t(polygon)].id; }

/// The place of a direction in the tables below.
std::size_t place_of(const PassingEdge& edge, bool opposite = false) {
    const bool is_less = (edge.side == Sign::negative) != opposite;
    return (edge.in_row ? 0U : 2U) + (is_less ? 0U : 1U);
}

using Directions = std::array<std::string_view, 4>;
constexpr InEachLanguage<Directions> passes_at{{"to the left", "to the right", "above", "below"},
                                               {"левее", "правее", "выше", "ниже"}};
constexpr InEachLanguage<Directions> moves_to{{"left", "right", "up", "down"}, {"влево", "вправо", "вверх", "вниз"}};

std::string distance(const PassingEdge& edge, Language language) {
    return as_written(edge.away) + InEachLanguage<std::string>{" px", " пикс."}.in(language);
}

/// "by 3/16", or "by more than 3/16" where equal depths would not do, or "at all".
std::string by(const Fraction& gap, bool ties_do, Language language) {
    const std::string number = as_written(gap);
    if (number == "0") return std::string(Bilingual{"at all", "хоть немного"}.in(language));
    if (ties_do) return std::string(Bilingual{"by ", "на "}.in(language)) + number;
    return std::string(Bilingual{"by more than ", "больше чем на "}.in(language)) + number;
}

/// "edge 2 of C passes 1/8 px to the left"
std::string passes(const PassingEdge& edge, const std::string& id, Language language) {
    const std::string number = std::to_string(edge.edge);
    const std::string direction(passes_at.in(language)[place_of(edge)]);
    if (language == Language::russian) {
        if (edge.side == Sign::zero) return "ребро " + number + " многоугольника " + id + " проходит через центр";
        return "ребро " + number + " многоугольника " + id + " проходит на " + distance(edge, language) + " " +
               direction;
    }
    if (edge.side == Sign::zero) return "edge " + number + " of " + id + " passes through the centre";
    return "edge " + number + " of " + id + " passes " + distance(edge, language) + " " + direction;
}

std::string beside(const AtPixel& found, const std::string& id, Language language) {
    const bool russian = language == Language::russian;
    std::string text;
    for (const auto& edge : found.edges) text += (text.empty() ? "" : ", ") + passes(edge, id, language);
    text += russian ? "; " + id + " виден, если " : "; " + id + " shows if ";
    for (std::size_t i = 0; i < found.edges.size(); ++i) {
        const auto& edge = found.edges[i];
        const std::string number = std::to_string(edge.edge), to(moves_to.in(language)[place_of(edge, true)]);
        if (i > 0) text += i + 1 < found.edges.size() || found.gap ? ", " : russian ? " и " : " and ";
        text += russian ? "ребро " + number + " сдвинуть " + to + " на " + distance(edge, language)
                        : "edge " + number + " moves " + to + " by " + distance(edge, language);
    }
    if (!found.gap) return text;
    const std::string rises = by(*found.gap, found.wins_ties, language);
    return text + (russian ? " и приблизить его " + rises : " and it rises " + rises);
}

std::string behind(const AtPixel& found, const std::string& id, Language language) {
    const bool russian = language == Language::russian;
    const std::string gap = as_written(*found.gap), rises = by(*found.gap, found.wins_ties, language);
    if (russian) {
        return id + (gap == "0" ? " здесь так же глубок и стоит в сцене позже" : " здесь дальше на " + gap) +
               "; виден, если приблизить его " + rises;
    }
    return id + (gap == "0" ? " is equally deep here and later in the scene" : " is " + gap + " farther here") +
           "; it shows if it rises " + rises;
}

std::string shows(const AtPixel& found, const Scene& scene, Language language) {
    const bool russian = language == Language::russian;
    const std::string id = id_of(found.polygon, scene);
    std::string text = russian ? id + " виден, глубина " : id + " shows, at depth ";
    text += as_written(*found.depth);
    if (found.next) {
        const std::string next = id_of(*found.next, scene), sinks = by(*found.gap, !found.wins_ties, language);
        text += russian ? "; если отдалить его " + sinks + ", виден " + next
                        : "; if it sinks " + sinks + ", " + next + " shows";
    }
    if (found.edges.empty()) return text;
    const PassingEdge& edge = found.edges.front();
    text += "; " + passes(edge, id, language);
    if (edge.side == Sign::zero) {
        return text + (russian ? ": если сдвинуть его внутрь, " + id + " здесь не виден"
                               : ": if it moves inward at all, " + id + " does not show");
    }
    const std::string to(moves_to.in(language)[place_of(edge, true)]);
    return text + (russian ? ": если сдвинуть его " + to + " дальше, " + id + " здесь не виден"
                           : ": if it moves " + to + " by more than that, " + id + " does not show");
}

// ------------------------------------------------------------------------------------- as JSON

void append_member(Text& out, std::string_view key, const std::optional<Fraction>& value) {
    if (!value) return;
    out += ",\"";
    out += key;
    out += "\":";
    append_string(out, value->text);
}

void append_edge(Text& out, const PassingEdge& edge) {
    constexpr Directions names{"left", "right", "above", "below"};
    out += "{\"edge\":";
    append_integer(out, edge.edge);
    out += ",\"passes\":";
    append_string(out, edge.side == Sign::zero ? std::string_view("through") : names[place_of(edge)]);
    out += ",\"away\":";
    append_string(out, edge.away.text);
    out += '}';
}

}  // namespace

std::string sentence(const AtPixel& found, const Scene& scene, Language language) {
    const std::string id = id_of(found.polygon, scene);
    switch (found.standing) {
        case Standing::shows: return shows(found, scene, language);
        case Standing::behind: return behind(found, id, language);
        case Standing::beside: return beside(found, id, language);
        case Standing::edge_on:
            return id + std::string(
                            Bilingual{" is edge-on and shows nowhere", " стоит ребром и нигде не виден"}.in(language));
    }
    std::abort();
}

std::string sentence_of_owner(const Reasons& reasons, int x, int y, std::optional<int> owner, const Scene& scene,
                              Language language) {
    if (owner) return sentence(reasons.at(x, y, *owner, owner), scene, language);
    return std::string(Bilingual{"no polygon shows", "не виден ни один многоугольник"}.in(language));
}

void append_at_pixel(Text& out, const AtPixel& found, const Scene& scene) {
    out += "{\"polygon\":";
    append_string(out, id_of(found.polygon, scene));
    out += ",\"standing\":";
    append_string(out, standing_names[std::size_t(found.standing)]);
    append_member(out, "depth", found.depth);
    append_member(out, "gap", found.gap);
    if (found.gap) out += found.wins_ties ? ",\"wins_ties\":true" : ",\"wins_ties\":false";
    if (found.next) {
        out += ",\"next\":";
        append_string(out, id_of(*found.next, scene));
    }
    if (!found.edges.empty()) {
        out += ",\"edges\":";
        char before = '[';
        for (const auto& edge : found.edges) {
            out += before;
            append_edge(out, edge);
            before = ',';
        }
        out += ']';
    }
    out += '}';
}

std::string why_json(const Reasons& reasons, int x, int y, const Scene& scene) {
    Text out;
    out += "{\"format\":\"vidno-why/1\",\"pixel\":[";
    append_integer(out, x);
    out += ',';
    append_integer(out, y);
    out += "],\"owner\":";
    const auto owner = reasons.owner(x, y);
    owner ? append_string(out, id_of(*owner, scene)) : void(out += "null");
    out += ",\"polygons\":";
    char before = '[';
    for (int i = 0; i < int(scene.polygons.size()); ++i) {
        out += before;
        append_at_pixel(out, reasons.at(x, y, i, owner), scene);
        before = ',';
    }
    if (before == '[') out += before;
    out += "]}\n";
    return out.string();
}

std::string why_text(const Reasons& reasons, int x, int y, const Scene& scene, Language language) {
    const std::string pixel = std::to_string(x) + "," + std::to_string(y);
    const auto owner = reasons.owner(x, y);
    std::string text = std::string(Bilingual{"pixel ", "пиксель "}.in(language)) + pixel + ": ";
    text += sentence_of_owner(reasons, x, y, owner, scene, language);
    text += '\n';
    for (int i = 0; i < int(scene.polygons.size()); ++i) {
        if (i != owner) text += "  " + sentence(reasons.at(x, y, i, owner), scene, language) + '\n';
    }
    return text;
}

}  // namespace vidno
