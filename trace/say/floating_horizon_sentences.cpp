/// The sentences and notes of the floating horizon.
#include "say/tables.h"

namespace vidno::say {

namespace {

constexpr Plurals columns_over{{"column", "", "columns"}, {"столбцом", "столбцами", "столбцами"}};

struct CurveSentences : CurveWords {
    using enum Line;
    using Said = std::string;

    Said operator()(const event::Horizons& e) const {
        if (!e.upper || !e.lower) {
            return say("There is no horizon over any column yet.", "Ни над одним столбцом горизонта ещё нет.");
        }
        return say("Over every column the upper horizon begins at {}, the lower one at {}.",
                   "Над каждым столбцом верхний горизонт начинается с {}, нижний — с {}.", *e.upper, *e.lower);
    }
    Said operator()(const event::Curve& e) const {
        if (e.curve == 0) return say("The first curve, 0, is the nearest.", "Первая кривая, 0, ближе всех.");
        return say("Curve {} is the next one.", "Следующая кривая — {}.", e.curve);
    }
    Said operator()(const event::SideEdge& e) const {
        return e.at == FH3 ? say("The left side edge now ends at {}.", "Левое боковое ребро дошло до {}.", e.sample)
                           : say("The right side edge now ends at {}.", "Правое боковое ребро дошло до {}.", e.sample);
    }

    // The segment

    Said operator()(const event::Visibility& e) const {
        const auto* height = after().height ? after().height->get_if<event::Height>() : nullptr;
        const Said there = height && height->x == e.x ? say(" at {}", " с ординатой {}", height->y) : "";
        return say("Over column {} the curve{} is {}.", "Над столбцом {} кривая{} {}.", e.x, there,
                   in(flag_of(e.flag)));
    }
    Said operator()(const event::Intersection& e) const {
        const auto [left, right] = e.columns;
        const Said where = left == right ? say("over column {}", "над столбцом {}", left)
                                         : say("between the columns {} and {}", "между столбцами {} и {}", left, right);
        return say("The segment meets {} at {}, {}.", "Отрезок встречается {} в точке {}, {}.", in(met_at(e.at)),
                   e.point, where);
    }
    Said operator()(const event::DrawLine& e) const {
        if (is_point(e)) return say("The curve is visible at the point {}.", "Кривая видна в точке {}.", e.from);
        const Bilingual why = e.at == FH6 ? Bilingual{"it is on one side all the way", "весь путь она на одной стороне"}
                              : e.at == FH7
                                  ? Bilingual{"then a horizon hides it, or it changes sides",
                                              "дальше её закрывает горизонт, или она переходит на другую сторону"}
                                  : Bilingual{"before, a horizon hid it, or it was on the other side",
                                              "до того её закрывал горизонт, или она была на другой стороне"};
        return say("The curve is drawn from {} to {}: {}.", "Кривая рисуется от {} до {}: {}.", e.from, e.to, in(why));
    }
    Said operator()(const event::Step& e) const {
        return e.changes
                   ? say("Over column {} the segment is on the other side of the horizon: they meet on the way here.",
                         "Над столбцом {} отрезок уже по другую сторону горизонта: он пересёк его перед этим столбцом.",
                         e.x)
                   : say("Over column {} the segment is still on the same side of the horizon.",
                         "Над столбцом {} отрезок по ту же сторону горизонта.", e.x);
    }

    // The horizons

    Said operator()(const event::Horizon& e) const {
        if (e.last < e.first) {
            return say("No column lies between: the horizons stay as they are.",
                       "Между ними нет ни одного столбца: горизонты прежние.");
        }
        const Said raised = say("the upper horizon rises over {}", "верхний горизонт поднимается над {}",
                                counted((long long)(e.upper.size()), columns_over));
        const Said lowered = say("the lower horizon falls over {}", "нижний горизонт опускается над {}",
                                 counted((long long)(e.lower.size()), columns_over));
        if (e.upper.empty() && e.lower.empty()) {
            return say("{}: both horizons stay as they are.", "{}: оба горизонта прежние.", over(e));
        }
        if (e.lower.empty()) return say("{}: {}.", "{}: {}.", over(e), raised);
        if (e.upper.empty()) return say("{}: {}.", "{}: {}.", over(e), lowered);
        return say("{}: {}, and {}.", "{}: {}, {}.", over(e), raised, lowered);
    }
    Said operator()(const event::Height& e) const {
        if (!e.upper || !e.lower) {
            return say("Over column {} the curve is at {}; no horizon is there.",
                       "Над столбцом {} ордината кривой {}; горизонта там нет.", e.x, e.y);
        }
        const auto [own, above] = apart(e.y, *e.upper, language());
        const auto below = apart(e.y, *e.lower, language()).second;
        return say("Over column {} the curve is at {}; the upper horizon is at {}, the lower one at {}.",
                   "Над столбцом {} ордината кривой {}, верхнего горизонта {}, нижнего {}.", e.x, own, above, below);
    }
    Said operator()(const event::Raise& e) const {
        return say("Over column {} the upper horizon moves to {}.",
                   "Над столбцом {} ордината верхнего горизонта теперь {}.", e.x, e.y);
    }
    Said operator()(const event::Lower& e) const {
        return say("Over column {} the lower horizon moves to {}.",
                   "Над столбцом {} ордината нижнего горизонта теперь {}.", e.x, e.y);
    }

    // Notes

    Said note(const event::Horizons& e) const { return heights({e.upper, e.lower}); }
    Said note(const event::Curve& e) const { return word(e.curve); }
    Said note(const event::SideEdge& e) const { return word(e.sample); }
    Said note(const event::Visibility& e) const { return (e.at == FH4 ? "Pflag = " : "Tflag = ") + word(int(e.flag)); }
    Said note(const event::Intersection& e) const { return word(e.point); }
    Said note(const event::DrawLine& e) const { return word(e.from) + " → " + word(e.to); }
    Said note(const event::Horizon& e) const {
        return e.last < e.first ? "∅" : "[" + list({double(e.first), double(e.last)}) + "]";
    }
    Said note(const event::Height& e) const { return heights({e.y, e.upper, e.lower}); }
    Said note(const event::Raise& e) const { return becomes(e); }
    Said note(const event::Lower& e) const { return becomes(e); }
    Said note(const event::Step& e) const { return word(e.x) + ": " + text_of(e.changes); }

    // Parts of these

    Bilingual flag_of(VisibilityFlag flag) const {
        switch (flag) {
            case VisibilityFlag::above:
                return {"visible (1): it is on the upper horizon or above it",
                        "видна (1): она на верхнем горизонте или выше него"};
            case VisibilityFlag::below:
                // The printed text draws nothing between two such points.
                if (header().edition.has(Deviation::x_h1)) {
                    return {"on the lower horizon or below it (−1)", "— на нижнем горизонте или ниже него (−1)"};
                }
                return {"visible (−1): it is on the lower horizon or below it",
                        "видна (−1): она на нижнем горизонте или ниже него"};
            case VisibilityFlag::hidden:
                return {"hidden (0): it is strictly between the horizons",
                        "не видна (0): она строго между горизонтами"};
            case VisibilityFlag::both:
                return {"visible (2): it is on both horizons, or there are none yet",
                        "видна (2): она на обоих горизонтах, или их ещё нет"};
        }
        return {};
    }
    /// The horizon that a segment meets. Which one differs between editions (X-H2) where the segment comes out of
    /// hiding below.
    Bilingual met_at(Line at) const {
        const Bilingual unknown{"the horizon", "с горизонтом"};
        const auto& [segment, previous, current] = after().place;
        if (!previous || !current) return unknown;
        const auto was = side_of(previous->second, current->second), is = side_of(current->second, previous->second);
        const auto side = at == FH7 ? was : is;
        if (side == VisibilityFlag::above) return {"the upper horizon", "с верхним горизонтом"};
        const bool is_lower = side == VisibilityFlag::below && was != VisibilityFlag::hidden;
        return is_lower ? Bilingual{"the lower horizon", "с нижним горизонтом"} : unknown;
    }
    static VisibilityFlag side_of(VisibilityFlag flag, VisibilityFlag neighbour) {
        return side_beside(flag, neighbour);
    }
    /// Whether a part of a segment is a point on a column.
    static bool is_point(const event::DrawLine& e) {
        const auto [first, last] = e.from_columns;
        return first == last && first == e.to_columns.second;
    }
    Said heights(const std::vector<std::optional<Value>>& all) const {
        std::vector<Said> texts;
        for (const auto& each : all) texts.push_back(each ? word(*each) : "∅");
        return joined(texts, between_numbers());
    }
    Said becomes(const auto& e) const { return "[" + word(e.x) + "] := " + word(e.y); }
    Said over(const event::Horizon& e) const {
        if (e.first == e.last) return say("Column {}", "Столбец {}", e.first);
        return say("Columns {0} to {1}", "Столбцы {2}", e.first, e.last, range(e.first, e.last));
    }
};

}  // namespace

std::string floating_horizon_sentence(const EventView& event, const CurveWords& words) {
    return sentence_in<FloatingHorizonState::Events>(CurveSentences{words}, event);
}

std::string floating_horizon_note(const EventView& event, const CurveWords& words) {
    return note_in<FloatingHorizonState::Events>(CurveSentences{words}, event);
}

const Noted noted_by_floating_horizon = noted_in<FloatingHorizonState::Events, CurveSentences>(AllEvents{});

}  // namespace vidno::say
