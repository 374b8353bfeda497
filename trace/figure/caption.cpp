#include "caption.h"

#include "figure_words.h"
#include "notation.h"
#include "parts.h"

namespace vidno::figures {

namespace {

/// The sentences of the events that have one. The others are described by their line of the listing.
struct Sentence {
    const State& state;
    Language language;

    using Text = std::string;

    Text say(const Text& english, const Text& russian) const {
        return InEachLanguage<Text>{english, russian}.in(language);
    }
    const Text& name(PolygonPlace polygon) const { return name(polygon.index); }
    const Text& name(int polygon) const { return state.header().scene.polygons[std::size_t(polygon)].id; }
    Text number(const Value& value) const { return readable(value, language); }
    Text at(const ValuePoint& point) const { return pair_of(number(point.x), number(point.y), language); }
    Text at(int x, int y) const { return pair_of(std::to_string(x), std::to_string(y), language); }
    Text name(const Window& window) const { return readable(window, language); }
    static Text listed(const std::vector<int>& edges) {
        Text text;
        for (const int edge : edges) text += (text.empty() ? "" : ", ") + std::to_string(edge);
        return text;
    }

    Text operator()(const event::Push& e) const {
        return say("window " + name(e.window) + " goes on the stack", "окно " + name(e.window) + " — в стек");
    }
    Text operator()(const event::Pop& e) const {
        return say("window " + name(e.window) + " is taken from the stack", "из стека взято окно " + name(e.window));
    }
    Text operator()(const event::Skip& e) const {
        return say("window " + name(e.window) + " lies outside the area",
                   "окно " + name(e.window) + " лежит вне области");
    }
    Text operator()(const event::Decide& e) const {
        switch (e.which) {
            case Case::empty: return say("the window is empty", "окно пусто");
            case Case::surrounded: return say("the window is surrounded", "окно охвачено");
            case Case::pixel: return say("the window is a pixel", "окно — пиксель");
            case Case::single: return say("the window has a single polygon", "в окне один многоугольник");
            case Case::split: return say("the window is split", "окно делится");
        }
        return {};
    }
    Text operator()(const event::Fill& e) const {
        const Text size = std::to_string(e.rect.width) + " × " + std::to_string(e.rect.height);
        return say(size + " pixels are filled", "заполняются " + size + " пикселей");
    }
    Text operator()(const event::Corners& e) const {
        return say("the corner depths start at " + number(e.z), "глубины в углах начинаются с " + number(e.z));
    }
    Text operator()(const event::Box& e) const {
        return e.outside ? say("the box of " + name(e.polygon) + " lies outside the window",
                               "габарит " + name(e.polygon) + " лежит вне окна")
                         : say("the box of " + name(e.polygon) + " meets the window",
                               "габарит " + name(e.polygon) + " задевает окно");
    }
    Text operator()(const event::Discard& e) const {
        return say(name(e.polygon) + " leaves the list", name(e.polygon) + " исключается из списка");
    }
    Text operator()(const event::Depth& e) const {
        return say(name(e.polygon) + " has z = " + number(e.z) + " at " + at(e.point),
                   "z = " + number(e.z) + " у " + name(e.polygon) + " в точке " + at(e.point));
    }
    Text operator()(const event::Nearer& e) const {
        const auto& words = words_of(language);
        if (e.corners.empty()) {
            return say(name(e.polygon) + " is nearer at no corner", name(e.polygon) + " не ближе ни в одном углу");
        }
        return name(e.polygon) + ", " + std::string(words.nearer_at) + ": " + places_of(e.corners, words);
    }
    Text operator()(const event::Mark& e) const {
        return say(name(e.polygon) + " surrounds the window", name(e.polygon) + " охватывает окно");
    }
    Text operator()(const event::Cover& e) const {
        return say(name(e.polygon) + " surrounds the window, nearest at its corners",
                   name(e.polygon) + " охватывает окно и ближе всех в углах");
    }
    Text operator()(const event::Uncover& e) const {
        return say(name(e.polygon) + " is nearer at a corner: hasSurround is false",
                   name(e.polygon) + " ближе в некотором углу: hasSurround ложно");
    }
    Text operator()(const event::Nearest& e) const {
        return say(name(e.polygon) + " is the nearest so far, z = " + number(e.z),
                   name(e.polygon) + " пока ближе всех, z = " + number(e.z));
    }
    Text operator()(const event::Surround& e) const {
        return e.inside ? say(at(e.point) + " lies inside " + name(e.polygon),
                              "точка " + at(e.point) + " лежит внутри " + name(e.polygon))
                        : say(at(e.point) + " lies outside " + name(e.polygon),
                              "точка " + at(e.point) + " лежит вне " + name(e.polygon));
    }
    Text operator()(const event::Draw& e) const {
        return say(name(e.polygon) + " is painted", name(e.polygon) + " закрашивается");
    }
    Text operator()(const event::Paint& e) const {
        return say(name(e.polygon) + " is painted", name(e.polygon) + " закрашивается");
    }
    Text operator()(const event::Clear& e) const {
        return say("every depth becomes " + number(e.z), "все глубины становятся равны " + number(e.z));
    }
    Text operator()(const event::Polygon& e) const {
        return say(name(e.polygon) + " is next", "следующий многоугольник — " + name(e.polygon));
    }
    Text operator()(const event::Scanline& e) const {
        return say("row " + std::to_string(e.row) + " begins", "начинается строка " + std::to_string(e.row));
    }
    Text operator()(const event::AelAdd& e) const {
        const Text edge = std::to_string(e.edge);
        return say("edge " + edge + " joins the active edges", "ребро " + edge + " становится активным");
    }
    Text operator()(const event::AelStep& e) const {
        const Text edge = std::to_string(e.edge), x = number(e.x);
        return say("edge " + edge + " moves to x = " + x, "ребро " + edge + " переходит к x = " + x);
    }
    Text operator()(const event::AelDrop& e) const {
        if (e.edges.empty()) return say("no edge leaves the active edges", "все активные рёбра остаются");
        return say("leave the active edges: " + listed(e.edges), "больше не активны рёбра: " + listed(e.edges));
    }
    Text operator()(const event::Columns& e) const {
        if (e.first >= e.end)
            return say("no pixel centre lies between the edges", "между рёбрами нет центров пикселей");
        const Text pixels = std::to_string(e.first) + "–" + std::to_string(e.end - 1);
        return say("pixels " + pixels + " lie between the edges", "между рёбрами — пиксели " + pixels);
    }
    Text operator()(const event::Pixel& e) const {
        const Text pixel = at(e.x, e.y);
        const Text compared = number(e.z) + (e.shown ? " > " : " ≯ ") + number(e.stored);
        return e.shown
                   ? say("pixel " + pixel + " is painted: " + compared, "пиксель " + pixel + " красится: " + compared)
                   : say("pixel " + pixel + " stays: " + compared, "пиксель " + pixel + " остаётся: " + compared);
    }
    Text operator()(const event::PopList& e) const {
        return say("a list is taken; it is clipped by " + name(e.clip), "взят список; его режет " + name(e.clip));
    }
    Text operator()(const event::PushList& e) const {
        const Text count = std::to_string(e.pieces.size());
        return say("a list goes on the stack, polygons: " + count, "в стек положен список, многоугольников: " + count);
    }
    Text operator()(const event::Entering& e) const {
        return say("the outline enters at " + at(e.point), "контур входит в точке " + at(e.point));
    }
    Text operator()(const event::Leaving& e) const {
        return say("the outline leaves at " + at(e.point), "контур выходит в точке " + at(e.point));
    }
    Text operator()(const event::Clipped& e) const {
        return say(name(e.polygon) + " is cut by the outline of " + name(e.clip),
                   name(e.polygon) + " разрезан контуром " + name(e.clip));
    }
    Text operator()(const event::Behind& e) const {
        return e.behind ? say(name(e.polygon) + " is behind there", name(e.polygon) + " там позади")
                        : say(name(e.polygon) + " is not behind there", name(e.polygon) + " там не позади");
    }
    Text operator()(const event::Show& e) const {
        return say(name(e.polygon) + " is visible there", name(e.polygon) + " там виден");
    }
    Text operator()(const auto&) const { return {}; }
};

std::string line_or_start(const auto& moment, Language language) {
    const auto at = moment.event() ? moment.event()->visit([](const auto& e) { return std::optional<Line>(e.at); })
                                   : std::optional<Line>();
    if (!at) return std::string(words_of(language).start);
    return std::string(line_names[std::size_t(*at)]) + ": " + text_of(*at, moment.header().edition, language);
}

}  // namespace

std::string caption_of(const Moment& moment, Language language) {
    std::string said;
    if (moment.event()) said = moment.event()->visit(Sentence{moment.state(), language});
    return said.empty() ? line_or_start(moment, language) : said;
}

std::string caption_of(const FloatingHorizonMoment& moment, Language language) {
    return line_or_start(moment, language);
}

std::string letter_of(std::size_t place) {
    constexpr std::size_t letters = 26;
    std::string text(1, char('a' + place % letters));
    if (place >= letters) text.insert(0, 1, char('a' + place / letters - 1));
    return "(" + text + ")";
}

}  // namespace vidno::figures
