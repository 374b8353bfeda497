/// The sentences and notes of the Z-buffer.
#include "say/tables.h"

namespace vidno::say {

namespace {

struct ZBufferSentences : PolygonWords {
    using Said = std::string;

    Said operator()(const event::Clear& e) const {
        return say("The picture is all background; every cell of the Z-buffer holds {}.",
                   "Изображение заполнено фоном, каждая ячейка Z-буфера — значением {}.", e.z);
    }
    Said operator()(const event::Polygon& e) const {
        return say("Next polygon: {}. S and the AEL are empty.", "Следующий многоугольник: {}. S и AEL пусты.",
                   e.polygon);
    }

    // The edges of a polygon: S and AEL

    Said operator()(const event::Edge& e) const {
        if (!e.rows) return say("Edge {} joins S.", "Ребро {} входит в S.", e.edge);
        const auto [first, last] = *e.rows;
        if (last < first) {
            return say("Edge {} joins S; it crosses the centre of no row.",
                       "Ребро {} входит в S; оно не пересекает центра ни одной строки.", e.edge);
        }
        if (first == last) return say("Edge {} joins S: row {}.", "Ребро {} входит в S: строка {}.", e.edge, first);
        return say("Edge {0} joins S: rows {1} to {2}.", "Ребро {0} входит в S: строки {3}.", e.edge, first, last,
                   range(first, last));
    }
    Said operator()(const event::Extent& e) const {
        return say("The polygon reaches from y = {} to {}.", "Многоугольник простирается от y = {} до {}.", e.ymin,
                   e.ymax);
    }
    Said operator()(const event::Scanline& e) const {
        return say("The scanline is row {}, y = {}.", "Строка развёртки {}, y = {}.", e.row, e.y);
    }
    Said operator()(const event::AelAdd& e) const {
        return has_rows() ? say("Edge {} begins: it joins the AEL at x = {}, z = {}; its last row is {}.",
                                "Ребро {} начинается: входит в AEL с x = {}, z = {}; последняя строка — {}.", e.edge,
                                e.x, e.z, e.until)
                          : say("Edge {} begins: it joins the AEL at x = {}, z = {} and ends at y = {}.",
                                "Ребро {} начинается: входит в AEL с x = {}, z = {} и кончается при y = {}.", e.edge,
                                e.x, e.z, e.until);
    }
    Said operator()(const event::Horizontal& e) const {
        return say("Edge {} is horizontal: it is drawn at once and does not join the AEL.",
                   "Ребро {} горизонтально: оно рисуется сразу и в AEL не входит.", e.edge);
    }
    Said operator()(const event::Leave& e) const {
        if (e.edges.empty()) return say("No edge leaves S.", "Из S ничего не удаляется.");
        const Said next = unless_infinite(
            e.next, has_rows() ? Bilingual{"; the next begins in row {}", "; следующее начинается в строке {}"}
                               : Bilingual{"; the next begins at y = {}", "; следующее начинается при y = {}"});
        return several(e.edges) ? say("Edges {} leave S{}.", "Рёбра {} удаляются из S{}.", and_last(e.edges), next)
                                : say("Edge {} leaves S{}.", "Ребро {} удаляется из S{}.", and_last(e.edges), next);
    }
    Said operator()(const event::AelSort& e) const {
        if (e.edges.empty()) return say("The AEL is empty.", "AEL пуст.");
        return say("The AEL from left to right: {}{}.", "AEL слева направо: {}{}.", joined(numbers(e.edges), ", "),
                   next_change(e.next));
    }
    Said operator()(const event::AelDrop& e) const {
        if (e.edges.empty()) return say("No edge ends here.", "Ни одно ребро здесь не заканчивается.");
        return several(e.edges)
                   ? say("Edges {} end here and leave the AEL{}.", "Рёбра {} заканчиваются и удаляются из AEL{}.",
                         and_last(e.edges), next_change(e.next))
                   : say("Edge {} ends here and leaves the AEL{}.", "Ребро {} заканчивается и удаляется из AEL{}.",
                         and_last(e.edges), next_change(e.next));
    }
    Said operator()(const event::AelStep& e) const {
        return say("Edge {} steps to x = {}, z = {}.", "Ребро {} делает шаг: x = {}, z = {}.", e.edge, e.x, e.z);
    }

    // ShowLine

    Said operator()(const event::ShownLine& e) const {
        return say("Row {} from x = {} (z = {}) to x = {} (z = {}).",
                   "Строка {} от x = {} (z = {}) до x = {} (z = {}).", e.row, e.from.x, e.from.y, e.to.x, e.to.y);
    }
    Said operator()(const event::Miss& e) const {
        return e.at == Line::L1 ? say("The row lies outside the area: nothing to show.",
                                      "Строка лежит вне области: показывать нечего.")
                                : say("No pixel of the area lies between the ends: nothing to show.",
                                      "Между концами нет ни одного пикселя области: показывать нечего.");
    }
    Said operator()(const event::Slope& e) const {
        if (is_nan(e.dz)) {
            return say("The change of z from pixel to pixel is not a number.",
                       "Изменение z от пикселя к пикселю — не число.");
        }
        return say("From pixel to pixel z changes by {}.", "От пикселя к пикселю z меняется на {}.", e.dz);
    }
    Said operator()(const event::Columns& e) const {
        if (e.first >= e.end) {
            return say("No pixel centre lies between the ends.", "Между концами нет ни одного центра пикселя.");
        }
        return say("{}: z = {} at the first.", "{}: z = {} в первом.", capital(columns(e.first, e.end - 1)), e.z);
    }
    Said operator()(const event::Pixel& e) const {
        const auto pixel = pair(double(e.x), double(e.y));
        const auto [depth, before] = apart(e.z, e.stored, language());
        // The printed text also shows what is as near, and nothing beyond 1.
        const bool is_nearer = order_of(e.z, e.stored) == Sign::positive;
        if (header().edition.has(Deviation::x_z7) && e.shown != is_nearer) {
            return e.shown ? say("Pixel {}: {} is as near as {}, so it shows.",
                                 "Пиксель {}: {} так же близко, как {}, и многоугольник виден.", pixel, depth, before)
                           : say("Pixel {}: {} is nearer than {} but greater than 1, so it stays hidden.",
                                 "Пиксель {}: {} ближе, чем {}, но больше 1, и многоугольник закрыт.", pixel, depth,
                                 before);
        }
        const Said is = say("{} is", "{}", depth), counts = say("{} counts as", "{} считается", depth);
        const Said own = agrees(e.shown, e.z, e.stored) ? is : counts;
        return e.shown ? say("Pixel {}: {} nearer than {}, so it shows.",
                             "Пиксель {}: {} ближе, чем {}, и многоугольник виден.", pixel, own, before)
                       : say("Pixel {}: {} not nearer than {}, so it stays hidden.",
                             "Пиксель {}: {} не ближе, чем {}, и многоугольник закрыт.", pixel, own, before);
    }
    Said operator()(const event::Span& e) const {
        const auto changed = pixels_in(e.runs);
        if (changed == 0) return say("No pixel of row {} changes.", "В строке {} ничего не меняется.", e.row);
        const auto polygon = after().z_buffer().polygon();
        return say("{} the colour of {} in row {}.", "{} цвет {} в строке {}.", takes(changed),
                   polygon ? word(*polygon) : "", e.row);
    }

    // Notes

    Said note(const event::Polygon& e) const { return word(e.polygon); }
    Said note(const event::Edge& e) const { return named(e); }
    Said note(const event::Extent& e) const { return list({e.ymin, e.ymax}); }
    Said note(const event::Scanline& e) const { return "yₜ = " + word(e.y); }
    Said note(const event::AelAdd& e) const { return named(e); }
    Said note(const event::Horizontal& e) const { return named(e); }
    Said note(const event::Leave& e) const { return side_by_side(e.edges); }
    Said note(const event::AelSort& e) const { return side_by_side(e.edges); }
    Said note(const event::AelDrop& e) const { return side_by_side(e.edges); }
    Said note(const event::AelStep& e) const { return std::to_string(e.edge) + ": " + word(e.x); }
    Said note(const event::ShownLine& e) const { return list({e.from.x, e.to.x}); }
    Said note(const event::Miss&) const { return text_of(true); }
    Said note(const event::Slope& e) const { return "Δz = " + word(e.dz); }
    Said note(const event::Columns& e) const { return half_open(e.first, e.end); }
    Said note(const event::Pixel& e) const {
        // The printed text also shows what is as near, and nothing beyond 1.
        const auto order = order_of(e.z, e.stored);
        if (e.shown && order == Sign::zero) {
            const auto [depth, before] = apart(e.z, e.stored, language());
            return depth + " ≥ " + before;
        }
        const bool is_beyond = !e.shown && order == Sign::positive && number_of(e.z) > 1;
        return is_beyond ? word(e.z) + " > 1" : nearer(e.z, e.stored, e.shown);
    }
    Said note(const event::Span& e) const {
        std::vector<Said> runs;
        for (const auto& run : e.runs) runs.push_back(half_open(run.first, run.end));
        return runs.empty() ? "∅" : joined(runs, " ");
    }

    // Parts of these

    /// Whether edges begin and end in rows; in the printed text they do so at numbers.
    bool has_rows() const { return header().edition != Edition::printed; }
    static bool several(const std::vector<int>& edges) { return edges.size() > 1; }
    static bool is_nan(const Value& value) {
        return value.fraction ? *value.fraction == "nan" : value.number != value.number;
    }
    static std::vector<std::string> numbers(const std::vector<int>& edges) {
        std::vector<std::string> words;
        for (const int edge : edges) words.push_back(std::to_string(edge));
        return words;
    }
    static Said named(const auto& e) { return "e = " + std::to_string(e.edge); }
    static Said side_by_side(const std::vector<int>& edges) {
        return edges.empty() ? "∅" : joined(numbers(edges), " ");
    }
    Said and_last(const std::vector<int>& edges) const { return listed(numbers(edges), in({"and", "и"})); }
    Said unless_infinite(const Value& next, const Bilingual& said) const {
        const bool is_infinite = next.fraction ? *next.fraction == "inf" : next == Value::infinite();
        return is_infinite ? "" : say(said.english, said.russian, next);
    }
    Said next_change(const Value& next) const {
        return unless_infinite(
            next, has_rows() ? Bilingual{"; the next change is in row {}", "; следующее изменение — в строке {}"}
                             : Bilingual{"; the next change is at y = {}", "; следующее изменение — при y = {}"});
    }
};

}  // namespace

std::string z_buffer_sentence(const EventView& event, const PolygonWords& words) {
    return sentence_in<ZBufferState::Events>(ZBufferSentences{words}, event);
}

std::string z_buffer_note(const EventView& event, const PolygonWords& words) {
    return note_in<ZBufferState::Events>(ZBufferSentences{words}, event);
}

const Noted noted_by_z_buffer = noted_in<ZBufferState::Events, ZBufferSentences>(AllEvents{});

}  // namespace vidno::say
