#include "caption.h"

#include "figure_words.h"
#include "notation.h"
#include "parts.h"

namespace vidno::figures {

namespace {

/// Text, numbers and points in a language.
struct Sayer {
    Language language;

    using Text = std::string;

    Text say(const Text& english, const Text& russian) const {
        return InEachLanguage<Text>{english, russian}.in(language);
    }
    Text number(const Value& value) const { return readable(value, language); }
    Text at(const ValuePoint& point) const { return pair_of(number(point.x), number(point.y), language); }
    Text at(int x, int y) const { return pair_of(std::to_string(x), std::to_string(y), language); }
};

/// The sentences of the events that have one. The others are described by their line of the listing.
struct Sentence : Sayer {
    const State& state;

    const Text& name(PolygonPlace polygon) const { return name(polygon.index); }
    const Text& name(int polygon) const { return state.header().scene.polygons[std::size_t(polygon)].id; }
    Text name(const Window& window) const { return readable(window, language); }
    Text names(const std::vector<PolygonPlace>& polygons) const {
        Text text;
        for (const auto polygon : polygons) text += (text.empty() ? "" : ", ") + name(polygon);
        return text;
    }
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
        return say(size + " pixels are filled", "закрашено пикселей: " + size);
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
        return e.shown ? say("pixel " + pixel + " is painted: " + compared,
                             "пиксель " + pixel + " закрашивается: " + compared)
                       : say("pixel " + pixel + " stays: " + compared, "пиксель " + pixel + " остаётся: " + compared);
    }
    Text operator()(const event::PopList& e) const {
        return say("a list is taken; it is clipped by " + name(e.clip), "взят список; отсекает " + name(e.clip));
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
    Text operator()(const event::Plane& e) const {
        return say("the plane of " + name(e.polygon) + " is found", "найдена плоскость " + name(e.polygon));
    }
    Text operator()(const event::Count& e) const {
        return say(name(e.polygon) + " is counted: " + std::to_string(e.count),
                   name(e.polygon) + " учтён: " + std::to_string(e.count));
    }
    Text operator()(const event::PointColor& e) const {
        return say("the colour at " + at(e.point) + " is found", "найден цвет в точке " + at(e.point));
    }
    Text operator()(const event::Orient& e) const {
        const Text edge = std::to_string(e.edge);
        const Text sign = e.sign == Sign::zero ? "0" : e.sign == Sign::positive ? "+" : "−";
        return say("edge " + edge + " of " + name(e.polygon) + " has the sign " + sign + " at " + at(e.point),
                   "знак ребра " + edge + " у " + name(e.polygon) + " в точке " + at(e.point) + ": " + sign);
    }
    Text operator()(const event::AelSort& e) const {
        return say("the active edges in order: " + listed(e.edges), "активные рёбра по порядку: " + listed(e.edges));
    }
    Text operator()(const event::Slope& e) const {
        return say("the depth changes by " + number(e.dz) + " a pixel",
                   "глубина меняется на " + number(e.dz) + " за пиксель");
    }
    Text operator()(const event::RelationFound& e) const {
        const Text& polygon = name(e.polygon);
        switch (e.relation) {
            case Relation::outside: return say(polygon + " is outside the window", polygon + " вне окна");
            case Relation::inside: return say(polygon + " is inside the window", polygon + " внутри окна");
            case Relation::intersecting: return say(polygon + " intersects the window", polygon + " пересекает окно");
            case Relation::surrounding: return say(polygon + " surrounds the window", polygon + " охватывает окно");
        }
        return {};
    }
    Text operator()(const event::Hiding& e) const {
        if (!e.polygon) return say("no polygon hides all others", "ни один многоугольник не закрывает остальные");
        return say(name(*e.polygon) + " hides all others", name(*e.polygon) + " закрывает остальные");
    }
    Text operator()(const event::Sorted& e) const {
        return say("the nearest first: " + names(e.polygons), "начиная с ближнего: " + names(e.polygons));
    }
    Text operator()(const event::Pierce& e) const {
        return say(name(e.polygon) + " and " + name(e.other) + " pierce each other",
                   name(e.polygon) + " и " + name(e.other) + " протыкают друг друга");
    }
    Text operator()(const event::GreatestDepth& e) const {
        return say("the greatest depth of " + name(e.polygon) + " is " + number(e.z),
                   "наибольшая глубина у " + name(e.polygon) + ": " + number(e.z));
    }
    Text operator()(const auto&) const { return {}; }
};

/// The same for a run of curves.
struct CurveSentence : Sayer {
    Text operator()(const event::Horizons& e) const {
        if (e.upper) return {};
        return say("there are no horizons yet", "горизонтов ещё нет");
    }
    Text operator()(const event::Curve& e) const {
        const Text curve = std::to_string(e.curve);
        return say("curve " + curve + " begins", "начинается кривая " + curve);
    }
    Text operator()(const event::SideEdge& e) const {
        const Text sample = pair_of(std::to_string(e.sample.first), number(e.sample.second), language);
        return e.at == Line::FH3 ? say("the left edge reaches " + sample, "левое ребро дошло до " + sample)
                                 : say("the right edge reaches " + sample, "правое ребро дошло до " + sample);
    }
    Text operator()(const event::Height& e) const {
        const Text x = std::to_string(e.x), y = number(e.y);
        return say("over column " + x + " the curve is at " + y, "над столбцом " + x + " кривая на высоте " + y);
    }
    Text operator()(const event::Visibility& e) const {
        const Text over = say("over column ", "над столбцом ") + std::to_string(e.x);
        switch (e.flag) {
            case VisibilityFlag::above: return over + say(" the curve is visible from above", " кривая видна сверху");
            case VisibilityFlag::below: return over + say(" the curve is visible from below", " кривая видна снизу");
            case VisibilityFlag::both:
                return over + say(" the curve is visible from both sides", " кривая видна с обеих сторон");
            case VisibilityFlag::hidden: return over + say(" the curve is hidden", " кривая скрыта");
        }
        return {};
    }
    Text operator()(const event::Intersection& e) const {
        return say("the curve meets the horizon at " + at(e.point), "кривая встречает горизонт в точке " + at(e.point));
    }
    Text operator()(const event::DrawLine& e) const {
        return say("the curve is drawn from " + at(e.from) + " to " + at(e.to),
                   "кривая рисуется от " + at(e.from) + " до " + at(e.to));
    }
    Text operator()(const event::Horizon& e) const {
        if (e.last < e.first) return say("the horizons stay as they are", "горизонты не меняются");
        const Text columns = std::to_string(e.first) + "–" + std::to_string(e.last);
        return say("the horizons now include the curve over columns " + columns,
                   "горизонты учли кривую над столбцами " + columns);
    }
    Text operator()(const event::Raise& e) const {
        const Text x = std::to_string(e.x), y = number(e.y);
        return say("over column " + x + " the upper horizon rises to " + y,
                   "над столбцом " + x + " верхний горизонт поднимается до " + y);
    }
    Text operator()(const event::Lower& e) const {
        const Text x = std::to_string(e.x), y = number(e.y);
        return say("over column " + x + " the lower horizon sinks to " + y,
                   "над столбцом " + x + " нижний горизонт опускается до " + y);
    }
    Text operator()(const auto&) const { return {}; }
};

std::string said_or_line(const auto& moment, const auto& sentence) {
    if (!moment.event()) return std::string(words_of(sentence.language).start);
    std::string said = moment.event()->visit(sentence);
    if (!said.empty()) return said;
    const Line at = moment.event()->visit([](const auto& e) { return e.at; });
    return std::string(line_names[std::size_t(at)]) + ": " + text_of(at, moment.header().edition, sentence.language);
}

}  // namespace

std::string caption_of(const Moment& moment, Language language) {
    return said_or_line(moment, Sentence{{language}, moment.state()});
}

std::string caption_of(const FloatingHorizonMoment& moment, Language language) {
    return said_or_line(moment, CurveSentence{{language}});
}

std::string letter_of(std::size_t place) {
    constexpr std::size_t letters = 26;
    std::string text(1, char('a' + place % letters));
    if (place >= letters) text.insert(0, 1, char('a' + place / letters - 1));
    return "(" + text + ")";
}

}  // namespace vidno::figures
