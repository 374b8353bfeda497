/// The sentences and notes of Weiler and Atherton's algorithm.
#include <cmath>

#include "say/tables.h"

namespace vidno::say {

namespace {

constexpr Plurals piece_forms{{"piece", "", "pieces"}, {"часть", "части", "частей"}};
constexpr Plurals list_of{{"piece", "", "pieces"}, {"части", "частей", "частей"}};
constexpr Plurals loop_forms{{"loop", "", "loops"}, {"контур", "контура", "контуров"}};

/// The corners of a region's bounding box. None if rounding has made a vertex non-finite.
struct Bounds {
    double left = HUGE_VAL, top = HUGE_VAL, right = -HUGE_VAL, bottom = -HUGE_VAL;
    bool is_finite = true;

    explicit Bounds(const RegionLoops& region) {
        for (const auto& loop : region) {
            for (const auto& point : loop) add(number_of(point.x), number_of(point.y));
        }
    }

private:
    void add(double x, double y) {
        is_finite = is_finite && std::isfinite(x) && std::isfinite(y);
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
};

struct WeilerAthertonSentences : PolygonWords {
    using enum Line;
    using Said = std::string;

    Said operator()(const event::Fault& e) const {
        if (e.at != RC4 && e.at != RC5 && e.at != SP3) return common_sentence(e, *this);
        return say("Rounding leaves an outline open here. The run drops it and continues.",
                   "Из-за округления контур здесь не замыкается. Он отбрасывается, и прогон идёт дальше.");
    }

    // The pieces and their order

    Said operator()(const event::CutToArea& e) const {
        if (e.region.empty()) {
            return say("No part of {} lies in the area: it is left out.",
                       "{} весь лежит вне области рисования и не участвует.", e.polygon);
        }
        return say("The part of {} in the area has {}.", "{} в области рисования: {}.", e.polygon,
                   counted(vertices_of(e.region), vertex_forms));
    }
    Said operator()(const event::Pierce& e) const {
        return say(
            "{0} and {1} pierce each other: the line where their planes meet, through {2}, divides what they share. In "
            "the direction {3}, {0} is nearer.",
            "{0} и {1} протыкают друг друга: прямая пересечения их плоскостей, проходящая через {2}, делит их общую "
            "часть. "
            "По направлению {3} от неё ближе {0}.",
            e.polygon, e.other, e.point, e.normal);
    }
    Said operator()(const event::Split& e) const {
        return say("{} is split along that line: each of its two pieces is on one side of the other polygon.",
                   "{} разрезан по этой линии: каждая из двух частей лежит по одну сторону другого многоугольника.",
                   e.polygon);
    }
    Said operator()(const event::Facets& e) const {
        return say("{}: no two of them pierce each other.", "{}: никакие две не протыкают друг друга.",
                   counted((long long)(e.pieces.size()), piece_forms));
    }
    Said operator()(const event::GreatestDepth& e) const {
        return say("The greatest depth of this piece of {} at its vertices is {}.",
                   "Наибольшая глубина этой части {} в её вершинах — {}.", e.polygon, e.z);
    }
    Said operator()(const event::Sorted& e) const {
        if (e.polygons.empty()) return say("There is nothing to sort.", "Сортировать нечего.");
        return say("The nearest first, by that depth: {}.", "По этой глубине, начиная с ближайшего: {}.",
                   some(names(e.polygons)));
    }

    // The lists

    Said operator()(const event::PushList& e) const {
        std::vector<std::string> all;
        for (const auto& piece : e.pieces) all.push_back(word(piece.polygon));
        if (e.at == WA3) {
            return say("The sorted list goes on the stack: {}.", "Отсортированный список кладётся в стек: {}.",
                       some(all));
        }
        if (e.at == WA6) {
            return say("What lies outside the clip polygon is handled separately: a list of {} ({}) goes on the stack.",
                       "То, что снаружи отсекающего многоугольника, рассматривается отдельно: в стек кладётся список "
                       "из {} ({}).",
                       counted((long long)(all.size()), list_of), some(all));
        }
        return say(
            "The clip polygon {0} is not the nearest here. What is nearer goes on the stack, and {0} comes last, as "
            "its "
            "ground: {1}.",
            "Отсекающий многоугольник {0} здесь не ближайший. В стек кладётся то, что ближе, и последним, как фон, сам "
            "{0}: {1}.",
            all.empty() ? "" : all.back(), some(all));
    }
    Said operator()(const event::PopList& e) const {
        return say("The list of {} comes off the stack: its first, a piece of {}, is the clip polygon.",
                   "Из стека взят список из {}: первая, от {}, — отсекающий многоугольник.", counted(e.count, list_of),
                   e.clip);
    }

    // Inside and outside of the clip polygon

    Said operator()(const event::Beside& e) const {
        const auto& list = current_list();
        const auto seen = list ? std::size_t(list->seen) : 0;
        if (!list || seen < 1 || list->pieces.size() < seen)
            return say("{} lies outside.", "{} лежит снаружи.", e.polygon);
        const PolygonPart &piece = *list->pieces[seen - 1], &clip = *list->pieces[0];
        const Said box = box_of(piece.region);
        return say("The box of {}{} lies beside that of {}{}: all of the piece is outside.",
                   "Габаритный прямоугольник {}{} не пересекается с прямоугольником {}{}: вся часть снаружи.",
                   e.polygon, box.empty() ? box : box + ",", clip.polygon, box_of(clip.region));
    }
    Said operator()(const event::Clipped& e) const {
        if (e.inside.empty()) {
            return say("No part of {} lies inside {}.", "Внутри {1} нет ничего от {0}.", e.polygon, e.clip);
        }
        if (e.at == SP1) {
            return say("{} and {} have a region of {} in common.", "Общая область {} и {}: {}.", e.polygon, e.clip,
                       size_of(e.inside));
        }
        if (e.outside.empty()) {
            return say("All of this piece of {} lies inside {}.", "Вся эта часть {} лежит внутри {}.", e.polygon,
                       e.clip);
        }
        return say("The outline of {1} cuts {0} in two: {2} inside; {3} outside.",
                   "Контур {1} делит {0} надвое: внутри {2}; снаружи {3}.", e.polygon, e.clip, size_of(e.inside),
                   size_of(e.outside));
    }
    Said operator()(const event::EdgePiece& e) const {
        return say("The outline from {} to {} lies {}.", "Контур от {} до {} — {}.", e.from, e.to, in(lies(e.lies)));
    }
    Said operator()(const event::Entering& e) const {
        return say("At {} the outline enters the clip region.", "В точке {} контур входит в отсекающую область.",
                   e.point);
    }
    Said operator()(const event::Leaving& e) const {
        return say("At {} the outline leaves the clip region.", "В точке {} контур выходит из отсекающей области.",
                   e.point);
    }

    // What is nearer

    Said operator()(const event::Behind& e) const {
        const auto [own, other] = apart(e.z, e.clip_z, language());
        const Said where =
            say("At {0}, the mean of its vertices, {1} has depth {2} and {3} has {4}",
                "В средней точке вершин {0} глубина {1} равна {2}, {3} — {4}", e.point, e.polygon, own, e.clip, other);
        const auto is =
            in(order_of(e.z, e.clip_z) == e.order ? Bilingual{} : Bilingual{"which counts as ", "считается, что "});
        if (e.order == Sign::zero) {
            return e.behind
                       ? say("{0}: {1}equal, and {3} comes first in the scene, so {2} is behind.",
                             "{0}: {1}глубины равны, и {3} в сцене раньше, поэтому {2} сзади.", where, is, e.polygon,
                             e.clip)
                       : say("{0}: {1}equal, and {2} comes first in the scene, so it is nearer.",
                             "{0}: {1}глубины равны, и {2} в сцене раньше, поэтому он ближе.", where, is, e.polygon);
        }
        return e.behind ? say("{}: {}less, so {} is behind, here and on the whole piece.",
                              "{}: {}меньше, поэтому {} сзади, здесь и на всей части.", where, is, e.polygon)
                        : say("{}: {}greater, so {} is nearer, here and on the whole piece.",
                              "{}: {}больше, поэтому {} ближе, здесь и на всей части.", where, is, e.polygon);
    }
    Said operator()(const event::NearerOnes& e) const {
        const Said clip = current_list() ? word(current_list()->pieces[0]->polygon)
                                         : Said(in({"the clip polygon", "отсекающего многоугольника"}));
        if (e.polygons.empty()) {
            return say("Nothing inside is nearer than {}: the rest inside is dropped.",
                       "Внутри нет ничего ближе {}: остальное внутри отбрасывается.", clip);
        }
        return say("Nearer than {0}: {1}. So {0} is not the nearest here.",
                   "Ближе {0}: {1}. Значит, {0} здесь не ближе всех.", clip, some(names(e.polygons)));
    }
    Said operator()(const event::Show& e) const {
        return say("{} is visible in this region of {}: nothing inside its outline is nearer.",
                   "{} виден в этой области ({}): внутри её контура нет ничего ближе.", e.polygon, size_of(e.region));
    }

    // PaintRegions

    Said operator()(const event::Row& e) const {
        const Said where =
            e.first < e.end ? columns(e.first, e.end - 1) : say("no pixel’s centre", "ни одного центра пикселя");
        return say("Row {} meets the region from {} to {}: {}.", "Строка {} пересекает область от {} до {}: {}.", e.row,
                   e.left, e.right, where);
    }
    Said operator()(const event::Order& e) const {
        constexpr std::array<Bilingual, 3> orders{
            {{"behind", "дальше, чем"}, {"as near as", "так же близко, как"}, {"nearer than", "ближе, чем"}}};
        const auto [own, other] = apart(e.z, e.other_z, language());
        const auto so = in(orders[place_of(e.order)]);
        if (order_of(e.z, e.other_z) != e.order) {
            return say("At the centre {} {} counts as {} {}: {} against {}.",
                       "В центре {} {} считается {} {}: {} против {}.", e.point, e.polygon, so, e.other, own, other);
        }
        return say("At the centre {} {} is {} {}: {} {} {}.", "В центре {} {} {} {}: {} {} {}.", e.point, e.polygon, so,
                   e.other, own, relation_of(e.order), other);
    }
    Said operator()(const event::Paint& e) const {
        const auto n = pixels_in(e.runs);
        if (n == 0) {
            return say("No pixel takes the colour of {}: the centres in this region are taken, or there are none.",
                       "Цвет {} не получает ни один пиксель: центры заняты, или их нет.", e.polygon);
        }
        const Said painted = counted(n, pixel_forms);
        if (language() == Language::russian)
            return say("", "Цвет {}: {} с центром в этой области.", e.polygon, painted);
        return n == 1 ? say("{} with its centre in this region takes the colour of {}.", "", painted, e.polygon)
                      : say("{} with their centres in this region take the colour of {}.", "", painted, e.polygon);
    }
    Said operator()(const event::Painted&) const {
        return say("All visible regions are painted.", "Все видимые области закрашены.");
    }

    // Notes: |n| is a region of n vertices, or a list of n pieces.

    Said note(const event::Row& e) const { return half_open(e.first, e.end); }
    Said note(const event::CutToArea& e) const { return word(e.polygon) + ": " + sized(e.region); }
    Said note(const event::Pierce& e) const { return word(e.polygon) + ", " + word(e.other); }
    Said note(const event::Split& e) const { return word(e.polygon) + ": " + sized(e.region) + ", " + sized(e.other); }
    Said note(const event::Facets& e) const { return "|L| = " + std::to_string(e.pieces.size()); }
    Said note(const event::GreatestDepth& e) const { return word(e.polygon) + ": " + word(e.z); }
    Said note(const event::Sorted& e) const { return side_by_side(names(e.polygons)); }
    Said note(const event::PushList& e) const {
        std::vector<Said> ids;
        for (const auto& piece : e.pieces) ids.push_back(word(piece.polygon));
        return side_by_side(ids);
    }
    Said note(const event::PopList& e) const { return "|L| = " + std::to_string(e.count) + ", C = " + word(e.clip); }
    Said note(const event::Beside& e) const { return word(e.polygon) + ": ∅, " + word(e.polygon); }
    Said note(const event::Clipped& e) const {
        return word(e.polygon) + ": " + sized(e.inside) + ", " + sized(e.outside);
    }
    Said note(const event::EdgePiece& e) const { return word(e.from) + " → " + word(e.to); }
    Said note(const event::Entering& e) const { return "→ " + word(e.point); }
    Said note(const event::Leaving& e) const { return "← " + word(e.point); }
    Said note(const event::Behind& e) const { return ordered(e.z, e.clip_z, e.order); }
    Said note(const event::NearerOnes& e) const { return "N = " + side_by_side(names(e.polygons)); }
    Said note(const event::Show& e) const { return word(e.polygon); }
    Said note(const event::Order& e) const { return ordered(e.z, e.other_z, e.order); }
    Said note(const event::Paint& e) const { return word(e.polygon); }

    // Parts of these

    static Said side_by_side(const std::vector<Said>& ids) { return ids.empty() ? "∅" : joined(ids, " "); }
    static Said sized(const RegionLoops& region) {
        return region.empty() ? "∅" : "|" + std::to_string(vertices_of(region)) + "|";
    }

    const std::optional<WeilerAthertonState::CurrentList>& current_list() const {
        return after().weiler_atherton().current_list();
    }
    static Bilingual lies(Lies where) {
        switch (where) {
            case Lies::inside: return {"inside the clip region", "внутри отсекающей области"};
            case Lies::outside: return {"outside the clip region", "снаружи отсекающей области"};
            case Lies::same_side:
                return {"on the outline of the clip region, with both regions on the same side: it counts as inside",
                        "на контуре отсекающей области, обе области по одну сторону от него: считается внутренним"};
            case Lies::other_side:
                return {"on the outline of the clip region, with one region on each side: it counts as outside",
                        "на контуре отсекающей области, области по разные стороны от него: считается внешним"};
        }
        return {};
    }
    static long long vertices_of(const RegionLoops& region) {
        long long count = 0;
        for (const auto& loop : region) count += (long long)(loop.size());
        return count;
    }
    /// "8 vertices, 2 loops".
    Said size_of(const RegionLoops& region) const {
        const Said size = counted(vertices_of(region), vertex_forms);
        return region.size() > 1 ? size + ", " + counted((long long)(region.size()), loop_forms) : size;
    }
    /// The corners of a region's bounding box, after a comma.
    Said box_of(const RegionLoops& region) const {
        const Bounds box(region);
        if (!box.is_finite) return "";
        return say(", {} – {}", ", {} – {}", pair(box.left, box.top), pair(box.right, box.bottom));
    }
};

}  // namespace

std::string weiler_atherton_sentence(const EventView& event, const PolygonWords& words) {
    return sentence_in<WeilerAthertonState::Events>(WeilerAthertonSentences{words}, event);
}

std::string weiler_atherton_note(const EventView& event, const PolygonWords& words) {
    return note_in<WeilerAthertonState::Events>(WeilerAthertonSentences{words}, event);
}

const Noted noted_by_weiler_atherton = noted_in<WeilerAthertonState::Events, WeilerAthertonSentences>(AllEvents{});

}  // namespace vidno::say
