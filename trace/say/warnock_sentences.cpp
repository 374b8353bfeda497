/// The sentences and notes of Warnock's algorithm and its variants.
#include "say/tables.h"
#include "say/warnock_words.h"

namespace vidno::say {

namespace {

constexpr Plurals row_forms{{"row", "", "rows"}, {"строке", "строках", "строках"}};
constexpr Plurals polygon_forms{{"polygon", "", "polygons"}, {"многоугольник", "многоугольника", "многоугольников"}};
constexpr Plurals time_forms{{"time", "", "times"}, {"раз", "раза", "раз"}};

std::string hex(const Color& color) {
    std::string text = "#";
    for (const auto part : {color.red, color.green, color.blue}) {
        for (const auto digit : {part / 16, part % 16}) text += "0123456789abcdef"[digit];
    }
    return text;
}

struct WarnockSentences : WarnockWords {
    using enum Line;
    using Said = std::string;

    // The windows

    Said operator()(const event::Push& e) const {
        if (is_at(e, {W3, WS1, WF1})) return first_pushed(e);
        if (e.at == WF12) return say("The part {} goes on the stack.", "Часть {} кладётся в стек.", e.window);
        if (e.shared.value_or(false)) {
            return say("The part {} goes on the stack with the same list.",
                       "Часть {} кладётся в стек с тем же списком.", e.window);
        }
        return say("The part {} goes on the stack with its own copy of the list.",
                   "Часть {} кладётся в стек с собственной копией списка.", e.window);
    }
    Said operator()(const event::Skip& e) const {
        return say("The part {} lies outside the area: it is skipped.", "Часть {} лежит вне области: она пропускается.",
                   e.window);
    }
    Said operator()(const event::Pop& e) const {
        if (e.at == WF2) {
            return say("The window {} comes off the stack: it is of level {}.",
                       "Окно {} берётся из стека, его уровень {}.", e.window, int(warnock().way().size()));
        }
        if (header().detail == Detail::windows) {
            return say("The window {} comes off the stack.", "Окно {} берётся из стека.", e.window);
        }
        return say("The window {0} comes off the stack with {1}.", "Окно {0} берётся из стека, {2}.", e.window,
                   some_or(current_list(), "an empty list"), its_list(current_list()));
    }
    Said operator()(const event::Decide& e) const {
        switch (e.which) {
            case Case::empty:
                return say("No polygon is left in the window: it takes the background.",
                           "В окне не осталось многоугольников: оно получает цвет фона.");
            case Case::surrounded:
                return say("{} hides everything: the window takes its colour.",
                           "{} закрывает всё: окно получает его цвет.",
                           name_or(hiding(), {"One polygon", "Один многоугольник"}));
            case Case::pixel:
                return say("The window is no larger than a pixel: the point at its centre decides.",
                           "Окно не больше пикселя: решает точка в его центре.");
            case Case::single: return single();
            case Case::split:
                return say("None of the simple cases: the window is split.",
                           "Ни один из простых случаев не подходит: окно делится.");
        }
        return {};
    }
    Said operator()(const event::Fill& e) const {
        return takes((long long)(e.rect.width) * e.rect.height) + " " + color_of(e) + ".";
    }

    // ProcessWindow

    Said operator()(const event::Corners& e) const {
        return say("Nothing is seen yet: the depth at all four corners starts at {}.",
                   "Пока ничего не видно: глубина во всех четырёх углах равна {}.", e.z);
    }
    Said operator()(const event::Box& e) const {
        return e.outside ? say("The box of {} lies outside the window.", "Габаритный прямоугольник {} лежит вне окна.",
                               e.polygon)
                         : say("The box of {} meets the window.", "Габаритный прямоугольник {} пересекается с окном.",
                               e.polygon);
    }
    Said operator()(const event::Discard& e) const {
        return say("{} is not counted in this window: it leaves the list.",
                   "{} в этом окне не учитывается: он удаляется из списка.", e.polygon);
    }
    Said operator()(const event::Count& e) const {
        return say("{} is counted in this window: polygonCount is now {}.",
                   "{} учитывается в этом окне: polygonCount теперь {}.", e.polygon, e.count);
    }
    Said operator()(const event::Depth& e) const {
        const auto of = e.at == PC3 ? say("{}", "{}", e.polygon) : say("the plane of {}", "плоскости {}", e.polygon);
        return say("{} {} has depth {}.", "{} глубина {} равна {}.", at(e.point), of, e.z);
    }
    Said operator()(const event::Compare& e) const {
        const auto [own, other] = apart(e.z, e.against, language());
        const auto so = in(e.nearer ? Bilingual{"nearer", "ближе"} : Bilingual{"not nearer", "не ближе"});
        if (!agrees(e.nearer, e.z, e.against)) {
            return say("{} {} counts as {}: {} against {}.", "{} {} считается {}: {} против {}.", compared_at(e),
                       e.polygon, so, own, other);
        }
        return say("{} {} is {}: {} {} {}.", "{} {} {}: {} {} {}.", compared_at(e), e.polygon, so, own,
                   e.nearer ? ">" : "≯", other);
    }
    Said operator()(const event::Nearer& e) const {
        if (e.k == 0) {
            return say("{} is nearer at none of the 4 corners.", "{} не ближе ни в одном из 4 углов.", e.polygon);
        }
        const Said corners = e.k == 4 ? "" : " (" + places_of(e.corners) + ")";
        return say("{} is nearer at {} of 4 corners{}.", "{} ближе в {} из 4 углов{}.", e.polygon, e.k, corners);
    }
    Said operator()(const event::Uncover& e) const {
        if (const auto hidden = warnock().uncovered()) {
            return say("{} is nearer somewhere, so {} no longer hides everything.",
                       "{} где-то ближе, и {} больше не закрывает всего.", e.polygon, *hidden);
        }
        return say("{} is nearer somewhere: for now nothing is known to hide everything.",
                   "{} где-то ближе: пока неизвестно, закрывает ли один из многоугольников остальные.", e.polygon);
    }
    Said operator()(const event::Mark& e) const {
        return say("All four corners lie in {}: it surrounds the window.",
                   "Все четыре угла лежат в {}: он охватывает окно.", e.polygon);
    }
    Said operator()(const event::Cover& e) const {
        return say("{} surrounds the window and is nearest at all four corners: it hides all so far.",
                   "{} охватывает окно и ближе всех в четырёх углах: он закрывает всё рассмотренное.", e.polygon);
    }
    Said operator()(const event::Insider& e) const {
        const auto [lies, does_not] = std::pair<Bilingual, Bilingual>{{"lies", "лежит"}, {"does not lie", "не лежит"}};
        const auto is = in(e.inside ? lies : does_not);
        if (e.at == RE2) {
            return say("The box of {} {} strictly inside the window.",
                       "Габаритный прямоугольник {} {} строго внутри окна.", e.polygon, is);
        }
        return say("The box of {}, the first that is counted, {} strictly inside the window.",
                   "Габаритный прямоугольник {}, первого из учтённых, {} строго внутри окна.", e.polygon, is);
    }
    Said operator()(const event::Summary& e) const {
        const Said one = name_or(warnock().covering(), {"one", "один из них"});
        const Said hides =
            e.has_surround ? say("{} hides all others", "{} закрывает остальные", one)
                           : say("none is known to hide the others", "неизвестно, закрывает ли один из них остальные");
        return say("{0} counted in the window; {2}.", "Учтено многоугольников в окне: {1}; {2}.",
                   counted(e.count, polygon_forms), e.count, hides);
    }

    // PointColor, SurroundTest

    Said operator()(const event::Nearest& e) const {
        return say("{} is the nearest at the point so far: z = {}.", "Пока в этой точке ближе всех {}: z = {}.",
                   e.polygon, e.z);
    }
    Said operator()(const event::PointColor& e) const {
        const auto [polygons, background] = owners(e);
        const Said seen = !polygons.empty() ? joined(polygons, in({" or ", " или "}))
                          : background      ? say("the background", "фон")
                                            : hex(e.color);
        return say("At {} the viewer sees {}.", "В точке {} виден {}.", e.point, seen);
    }
    Said operator()(const event::Surround& e) const {
        const auto is = in(e.inside ? Bilingual{"in", "в"} : Bilingual{"outside", "вне"});
        const auto corner = corner_at(e.point);
        if (!corner) return say("The point {} lies {} {}.", "Точка {} лежит {} {}.", e.point, is, e.polygon);
        return say("The {0} corner lies {2} {3}.", "{1} угол лежит {2} {3}.", place_of(*corner),
                   capital(Said(place_of(*corner))), is, e.polygon);
    }
    Said operator()(const event::Orient& e) const {
        const auto what = tested(e);
        switch (e.sign) {
            case Sign::negative:
                return say("{} lies on the negative side of edge {} of {} ({}).",
                           "{} лежит по отрицательную сторону ребра {} многоугольника {} ({}).", what, e.edge,
                           e.polygon, e.value);
            case Sign::zero:
                return say("{} lies on the line of edge {} of {} ({}).",
                           "{} лежит на прямой ребра {} многоугольника {} ({}).", what, e.edge, e.polygon, e.value);
            case Sign::positive:
                return say("{} lies on the positive side of edge {} of {} ({}).",
                           "{} лежит по положительную сторону ребра {} многоугольника {} ({}).", what, e.edge,
                           e.polygon, e.value);
        }
        return {};
    }

    // PolygonClip, FillPolygon

    Said operator()(const event::ClipBegin& e) const {
        return say("{} is clipped by the window’s four sides in turn.",
                   "{} отсекается по очереди четырьмя сторонами окна.", e.polygon);
    }
    Said operator()(const event::ClipSide& e) const {
        return say("Side {} of 4{}, from {} to {}: the new list is empty.",
                   "Сторона {} из 4{}, от {} до {}: новый список пуст.", e.side, side_along(e), e.from, e.to);
    }
    Said operator()(const event::ClipSign& e) const {
        switch (e.sign) {
            case Sign::negative:
                return say("The vertex {} lies on the negative side of this line and counts as inside.",
                           "Вершина {} лежит по отрицательную сторону этой прямой и считается внутренней.", e.vertex);
            case Sign::zero:
                return say("The vertex {} lies on this line and counts as inside.",
                           "Вершина {} лежит на этой прямой и считается внутренней.", e.vertex);
            case Sign::positive:
                return say("The vertex {} lies on the positive side of this line and counts as outside.",
                           "Вершина {} лежит по положительную сторону этой прямой и считается внешней.", e.vertex);
        }
        return {};
    }
    Said operator()(const event::ClipCross& e) const {
        if (is_within_side(e.vertex)) {
            return say("The edge crosses the side at {}: the crossing joins the new list.",
                       "Ребро пересекает сторону в точке {}: эта точка входит в новый список.", e.vertex);
        }
        return say("The edge crosses the side’s line at {}, beyond the side itself: the crossing joins the new list.",
                   "Ребро пересекает прямую стороны в точке {}, за пределами самой стороны: эта точка входит в новый "
                   "список.",
                   e.vertex);
    }
    Said operator()(const event::ClipKeep& e) const {
        return say("The vertex {} joins the new list.", "Вершина {} входит в новый список.", e.vertex);
    }
    Said operator()(const event::ClipDrop& e) const {
        return say("The vertex {} counts as outside and is dropped.", "Вершина {} считается внешней и отбрасывается.",
                   e.vertex);
    }
    Said operator()(const event::ClipList& e) const {
        if (e.count == 0) return say("Nothing is left.", "Ничего не осталось.");
        return say("This side is done: {} in the list.", "Сторона пройдена: в списке {}.",
                   counted(e.count, vertex_forms));
    }
    Said operator()(const event::ClipResult& e) const {
        if (e.vertices.empty()) {
            return say("Clipping leaves nothing of {}.", "После отсечения от {} ничего не осталось.", e.polygon);
        }
        return say("Clipping leaves a part of {} with {}.", "После отсечения от {} осталась часть: {}.", e.polygon,
                   counted((long long)(e.vertices.size()), vertex_forms));
    }
    Said operator()(const event::Row& e) const {
        const Said met = only().value_or(Said(in({"the polygon", "многоугольник"})));
        const Said where =
            e.first < e.end ? columns(e.first, e.end - 1) : say("no pixel’s centre", "ни одного центра пикселя");
        return say("Within the window, row {} meets {} from {} to {}: {}.",
                   "Строка {} в пределах окна пересекает {} от {} до {}: {}.", e.row, met, e.left, e.right, where);
    }
    Said operator()(const event::Draw& e) const {
        if (e.runs.empty()) {
            return say("No pixel takes the colour of {}: it covers no pixel’s centre here.",
                       "Ни один пиксель не получает цвет {}: здесь он не накрывает ни одного центра пикселя.",
                       e.polygon);
        }
        return say("{} the colour of {} in {}.", "{} цвет {} в {}.", takes(pixels_in(e.runs)), e.polygon,
                   counted((long long)(e.runs.size()), row_forms));
    }

    // The variants: the three lists

    Said operator()(const event::BackFace& e) const {
        return e.away ? say("{} runs clockwise: it looks away from the viewer and does not take part.",
                            "{} обходится по часовой стрелке: это нелицевая грань, и она не участвует.", e.polygon)
                      : say("{} runs counter-clockwise: it looks towards the viewer and takes part.",
                            "{} обходится против часовой стрелки: это лицевая грань, и она участвует.", e.polygon);
    }
    Said operator()(const event::Rejoin& e) const {
        const auto found = in(e.list == OtherList::surrounding ? Bilingual{"surround", "охватывающим"}
                                                               : Bilingual{"lie outside", "внешним"});
        return say(
            "{} was found to {} a window of level {}, and this window is not part of that one: it goes back to the "
            "third "
            "list.",
            "{} признан {} для окна уровня {}, а это окно — не его часть: он возвращается в третий список.", e.polygon,
            found, e.level);
    }
    Said operator()(const event::Join& e) const {
        const auto list = in(e.list == OtherList::surrounding ? Bilingual{"surrounding", "охватывающих"}
                                                              : Bilingual{"outside", "внешних"});
        return say("{} joins the {} polygons at level {}: this relation holds for all parts of this window.",
                   "{} входит в список {}, уровень {}: так будет и для всех частей этого окна.", e.polygon, list,
                   e.level);
    }
    Said operator()(const event::RelationFound& e) const {
        switch (e.relation) {
            case Relation::outside: return say("{} lies outside the window.", "{} лежит вне окна.", e.polygon);
            case Relation::inside:
                return say("{} lies wholly inside the window.", "{} лежит целиком внутри окна.", e.polygon);
            case Relation::intersecting:
                return say("{} intersects the window: an edge meets it.",
                           "{} пересекает окно: через окно проходит ребро.", e.polygon);
            case Relation::surrounding: return say("{} surrounds the window.", "{} охватывает окно.", e.polygon);
        }
        return {};
    }

    // The variants: TrialFunction, RayCrossings, OctantAngles

    Said operator()(const event::Trial& e) const {
        return e.meets ? say("Edge {} of {} meets the window.", "Ребро {} многоугольника {} пересекает окно.", e.edge,
                             e.polygon)
                       : say("Edge {} of {} does not meet the window.",
                             "Ребро {} многоугольника {} не пересекает окно.", e.edge, e.polygon);
    }
    Said operator()(const event::Meets& e) const {
        return e.meets ? say("An edge of {} meets the window.", "Одно из рёбер {} пересекает окно.", e.polygon)
                       : say("No edge of {} meets the window: it surrounds the window, or lies outside.",
                             "Ни одно ребро {} не пересекает окна: он охватывает окно или лежит вне его.", e.polygon);
    }
    Said operator()(const event::Ray& e) const {
        const Said so = say("{} so far", "пока {}", containment());
        if (e.at == CR4) {
            return e.counts == 1 ? say("Edge {} crosses the ray: {}.", "Ребро {} пересекает луч: {}.", e.edge, so)
                                 : say("Edge {} passes to the left of where the ray begins: {}.",
                                       "Ребро {} проходит левее начала луча: {}.", e.edge, so);
        }
        if (e.counts > 0 && header().edition == Edition(Deviation::vertex_counted_twice)) {
            return say("The beginning of edge {} lies on the ray: touching or piercing, it counts as two here; {}.",
                       "Начало ребра {} лежит на луче: и касание, и протыкание здесь считаются за два: {}.", e.edge,
                       so);
        }
        if (e.counts == 2) {
            return say(
                "The beginning of edge {} lies on the ray, where the outline touches it, which counts as two: {}.",
                "Начало ребра {} лежит на луче. Контур там касается луча: это два пересечения, {}.", e.edge, so);
        }
        if (e.counts == 1) {
            return say(
                "The beginning of edge {} lies on the ray, where the outline pierces it, which counts as one: {}.",
                "Начало ребра {} лежит на луче. Контур там протыкает луч: это одно пересечение, {}.", e.edge, so);
        }
        return say("The beginning of edge {} lies to the left of where the ray begins: {}.",
                   "Начало ребра {} лежит левее начала луча: {}.", e.edge, so);
    }
    Said operator()(const event::Crossings& e) const {
        const Said often = counted(e.count, time_forms);
        return e.count % 2 == 1
                   ? say("The outline of {} crosses the ray {}: odd, so it surrounds the window.",
                         "Контур {} пересекает луч {}: число нечётное, поэтому он охватывает окно.", e.polygon, often)
                   : say("The outline of {} crosses the ray {}: even, so it lies outside.",
                         "Контур {} пересекает луч {}: число чётное, поэтому он лежит вне окна.", e.polygon, often);
    }
    Said operator()(const event::Octants& e) const {
        const Said turn = signed_number(e.difference), sum = signed_number(containment());
        if (e.at != OA4) {
            return say("Edge {} goes from octant {} to octant {}: {}; the sum is {}.",
                       "Ребро {} идёт из октанта {} в октант {}: {}; сумма {}.", e.edge, e.from, e.to, turn, sum);
        }
        return say(
            "Edge {} goes from octant {} to octant {}, the opposite one: split by a side of the window, it turns by "
            "{}; "
            "the sum is {}.",
            "Ребро {} идёт из октанта {} в октант {}, противоположный: разбитое стороной окна, оно даёт {}; сумма {}.",
            e.edge, e.from, e.to, turn, sum);
    }
    Said operator()(const event::Angle& e) const {
        if (e.octants == 0) {
            return say("The turns of {} cancel: the sum is 0 octants, so it lies outside the window.",
                       "Повороты {} взаимно уничтожаются: сумма 0 октантов, поэтому он лежит вне окна.", e.polygon);
        }
        return say("{} runs around the window: the sum is {} octants, so it surrounds the window.",
                   "{} обходит окно кругом: сумма {} октантов, поэтому он охватывает окно.", e.polygon,
                   signed_number(e.octants));
    }

    // The variants: HidingPolygon, VertexSplit, EdgeDepth

    Said operator()(const event::Hiding& e) const {
        if (!e.polygon) {
            return say("No surrounding polygon is known to hide all others.",
                       "Неизвестно, закрывает ли охватывающий многоугольник все остальные.");
        }
        return say("{} surrounds the window and lies in front of all others: it hides them.",
                   "{} охватывает окно и лежит впереди всех: он закрывает остальные.", *e.polygon);
    }
    Said operator()(const event::SplitVertex& e) const {
        if (!e.splits) {
            return say(
                "Vertex {} of {} lies in the window, but next to it, at x = {}, y = {}, there is nothing to split.",
                "Вершина {} многоугольника {} лежит в окне, но рядом с ней, x = {}, y = {}, делить нечего.", e.vertex,
                e.polygon, e.column, e.row);
        }
        return say("Vertex {} of {} lies in the window, which is split next to it, at x = {}, y = {}.",
                   "Вершина {} многоугольника {} лежит в окне: оно делится рядом с ней, x = {}, y = {}.", e.vertex,
                   e.polygon, e.column, e.row);
    }
    Said operator()(const event::EdgeDepth& e) const {
        return say("{} is seen edge-on; its edge {} has depth {} at the point.",
                   "{} виден с ребра; глубина его ребра {} в этой точке равна {}.", e.polygon, e.edge, e.z);
    }

    // Notes

    Said note(const event::Push& e) const { return word(e.window); }
    Said note(const event::Skip& e) const { return word(e.window); }
    Said note(const event::Pop& e) const { return word(e.window); }
    Said note(const event::Decide&) const { return text_of(true); }
    Said note(const event::Fill& e) const {
        return std::to_string(e.rect.width) + " × " + std::to_string(e.rect.height);
    }
    Said note(const event::Corners& e) const { return "z = " + word(e.z); }
    Said note(const event::Box& e) const { return text_of(e.outside); }
    Said note(const event::Discard& e) const { return "− " + word(e.polygon); }
    Said note(const event::Count& e) const { return word(e.count); }
    Said note(const event::Compare& e) const { return nearer(e.z, e.against, e.nearer); }
    Said note(const event::Nearer& e) const { return "k = " + word(e.k); }
    Said note(const event::Uncover&) const { return text_of(false); }
    Said note(const event::Mark&) const { return text_of(true); }
    Said note(const event::Cover& e) const { return text_of(true) + ", " + word(e.polygon); }
    Said note(const event::Insider& e) const { return text_of(e.inside); }
    Said note(const event::Summary& e) const {
        return joined({word(e.count), text_of(e.has_surround), text_of(e.insider)}, ", ");
    }
    Said note(const event::Nearest& e) const { return word(e.polygon) + ": " + word(e.z); }
    Said note(const event::PointColor& e) const { return hex(e.color); }
    Said note(const event::Surround& e) const { return text_of(e.inside); }
    Said note(const event::Orient& e) const { return with_sign(e.value, e.sign); }
    Said note(const event::ClipBegin& e) const { return word(e.polygon); }
    Said note(const event::ClipSide& e) const { return "i = " + word(e.side); }
    Said note(const event::ClipSign& e) const { return with_sign(e.value, e.sign); }
    Said note(const event::ClipCross& e) const { return in_space(e.vertex); }
    Said note(const event::ClipKeep& e) const { return in_space(e.vertex); }
    Said note(const event::ClipDrop& e) const { return "− " + in_space(e.vertex); }
    Said note(const event::ClipList& e) const { return "|P′| = " + word(e.count); }
    Said note(const event::ClipResult& e) const { return "|P′| = " + word(int(e.vertices.size())); }
    Said note(const event::Row& e) const { return half_open(e.first, e.end); }
    Said note(const event::Draw& e) const { return word(e.polygon); }
    Said note(const event::BackFace& e) const { return text_of(e.away); }
    Said note(const event::Rejoin& e) const { return word(e.polygon) + ", " + word(e.level); }
    Said note(const event::Join& e) const { return word(e.polygon) + ", " + word(e.level); }
    Said note(const event::Trial& e) const { return text_of(e.meets); }
    Said note(const event::Meets& e) const { return text_of(e.meets); }
    Said note(const event::Ray& e) const { return "+ " + word(e.counts); }
    Said note(const event::Crossings& e) const { return "n = " + word(e.count); }
    Said note(const event::Octants& e) const {
        return word(e.from) + " → " + word(e.to) + ": " + signed_number(e.difference);
    }
    Said note(const event::Angle& e) const { return "S = " + signed_number(e.octants); }
    Said note(const event::Hiding& e) const { return e.polygon ? word(*e.polygon) : "∅"; }
    Said note(const event::SplitVertex& e) const { return word(e.column) + ", " + word(e.row); }
    Said note(const event::EdgeDepth& e) const { return word(e.edge) + ": " + word(e.z); }

    // Parts of these

    Said in_space(const ValueVertex& vertex) const { return "(" + list({vertex.x, vertex.y, vertex.z}) + ")"; }

    static Said some_or(const std::vector<std::string>& names, const char* nothing) {
        return names.empty() ? nothing : some(names);
    }
    static Said its_list(const std::vector<std::string>& names) {
        return names.empty() ? "его список пуст" : "его список: " + some(names);
    }
    Said first_pushed(const event::Push& e) const {
        const auto list = e.apl ? entries(*e.apl) : std::vector<std::string>{};
        return say("The first window, {0}, goes on the stack with {1}.", "Первое окно {0} кладётся в стек, {2}.",
                   e.window, some_or(list, "no polygon"), its_list(list));
    }
    Said single() const {
        return say("Only {0} is left in the window: background first, then {1}.",
                   "В окне остался только {0}: сначала фон, затем {1}.",
                   only().value_or(Said(in({"one polygon", "один многоугольник"}))),
                   only().value_or(Said(in({"the polygon", "он сам"}))));
    }
    Said color_of(const event::Fill& e) const {
        auto [owners_of_it, background] = owners(e);
        if (owners_of_it.empty() && background) return say("the background", "цвет фона");
        if (owners_of_it.empty()) return say("the colour {}", "цвет {}", hex(e.color));
        if (owners_of_it.size() == 1 && !background) return say("the colour of {}", "цвет {}", owners_of_it[0]);
        if (background) owners_of_it.emplace_back(in({"the background", "фона"}));
        return say("the colour that {} share", "общий цвет {}", listed(owners_of_it, in({"and", "и"})));
    }
    Said compared_at(const event::Compare& e) const {
        if (!e.corner) return say("At the point", "В точке");
        return say("At the {0}", "{1}", place_of(*e.corner), capital(Said(in_corner[std::size_t(*e.corner)])));
    }
    /// The point whose side of an edge is determined: the tested point itself at S2, S3 and ED3.
    Said tested(const event::Orient& e) const {
        if (e.at == CR4) {
            return say("The centre of the window, where the ray begins,", "Центр окна, начало луча,");
        }
        if (e.at == BF1) return say("The next vertex", "Следующая вершина");
        if (!is_at(e, {TF2, OA4})) return say("The point", "Точка");
        const auto corner = corner_at(e.point);
        const Said what = corner ? say("The {} corner", "Угол окна ({})", place_of(*corner))
                                 : say("The point {}", "Точка {}", e.point);
        return e.at == OA4 && language() == Language::english ? what + " of the window" : what;
    }
    /// Whether a point of the line by which PolygonClip clips lies on the side of the window itself.
    bool is_within_side(const ValueVertex& point) const {
        const auto& side = warnock().clip_side();
        if (!side) return false;
        const bool is_level = order_of(side->from.y, side->to.y) == Sign::zero;
        const Value& along = is_level ? point.x : point.y;
        return order_of(along, is_level ? side->from.x : side->from.y) !=
               order_of(along, is_level ? side->to.x : side->to.y);
    }
    /// The side of the window on which the line lies, after a comma.
    Said side_along(const event::ClipSide& e) const {
        if (!window()) return "";
        const Window& of = window()->window;
        const auto at_x = [&](double x) { return number_of(e.from.x) == x && number_of(e.to.x) == x; };
        const auto at_y = [&](double y) { return number_of(e.from.y) == y && number_of(e.to.y) == y; };
        if (at_y(of.y)) return say(", the top one", ", верхняя");
        if (at_x(of.x)) return say(", the left one", ", левая");
        if (at_y(of.bottom())) return say(", the bottom one", ", нижняя");
        if (at_x(of.right())) return say(", the right one", ", правая");
        return "";
    }
};

}  // namespace

std::string warnock_sentence(const EventView& event, const PolygonWords& words) {
    return sentence_in<WarnockState::Events>(WarnockSentences{WarnockWords(words)}, event);
}

std::string warnock_note(const EventView& event, const PolygonWords& words) {
    return note_in<WarnockState::Events>(WarnockSentences{WarnockWords(words)}, event);
}

const Noted noted_by_warnock = noted_in<WarnockState::Events, WarnockSentences>(AllEvents{});

}  // namespace vidno::say
