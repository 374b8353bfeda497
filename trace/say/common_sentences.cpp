/// The sentences of the events that all algorithms have.
#include "format/decision_words.h"
#include "format/fault_reason.h"
#include "say/tables.h"

namespace vidno::say {

namespace {

/// The purpose of a procedure that another one calls, as a question.
constexpr Bilingual purpose_of(Procedure procedure) {
    switch (procedure) {
        case Procedure::process_window:
            return {"which polygons matter in this window, and does one hide all others?",
                    "какие многоугольники учитываются в окне и закрывает ли один из них остальные?"};
        case Procedure::point_color:
            return {"which polygon is nearest at the centre?", "какой многоугольник ближе всех в центре?"};
        case Procedure::surround_test:
            return {"does the point lie in the polygon?", "лежит ли точка в многоугольнике?"};
        case Procedure::polygon_clip:
            return {"which part of the polygon lies in the window?", "какая часть многоугольника лежит в окне?"};
        case Procedure::fill_polygon:
            return {"which pixels have their centre in the polygon?", "у каких пикселей центр лежит в многоугольнике?"};
        case Procedure::show_line:
            return {"where on this row is the polygon the nearest?", "где в этой строке многоугольник ближе всех?"};
        case Procedure::side_edge:
            return {"what does the side of the surface hide?", "что закрывает собой бок поверхности?"};
        case Procedure::visibility:
            return {"where is the curve relative to the horizons over this column?",
                    "как кривая расположена относительно горизонтов над этим столбцом?"};
        case Procedure::horizon:
            return {"over which columns does the segment go beyond the horizons?",
                    "над какими столбцами отрезок выходит за горизонты?"};
        case Procedure::intersection:
            return {"where does the segment meet the horizon?", "где отрезок встречается с горизонтом?"};
        case Procedure::relation:
            return {"what is the relation of the polygon to the window?",
                    "как многоугольник расположен относительно окна?"};
        case Procedure::trial_function:
            return {"does an edge of the polygon meet the window?",
                    "пересекает ли окно хотя бы одно ребро многоугольника?"};
        case Procedure::ray_crossings:
            return {"how often does the outline cross a ray from the centre of the window?",
                    "сколько раз луч из центра окна пересекает контур?"};
        case Procedure::octant_angles:
            return {"how far does the outline turn around the window?",
                    "на какой угол контур поворачивает вокруг окна?"};
        case Procedure::hiding_polygon:
            return {"does a surrounding polygon lie in front of all others?",
                    "лежит ли охватывающий многоугольник впереди всех?"};
        case Procedure::split_piercing:
            return {"which polygons pierce each other, and along which line?",
                    "какие многоугольники протыкают друг друга и вдоль какой линии?"};
        case Procedure::depth_sort: return {"which piece may be the nearest?", "какая часть может быть ближайшей?"};
        case Procedure::region_clip:
            return {"which part of the piece lies inside the clip region, and which outside?",
                    "что лежит внутри отсекающей области, а что снаружи?"};
        case Procedure::remove_behind:
            return {"which parts inside are nearer than the clip polygon?",
                    "какие части внутри ближе отсекающего многоугольника?"};
        case Procedure::paint_regions:
            return {"which pixels have their centre in a visible region?",
                    "центры каких пикселей лежат в видимых областях?"};
        case Procedure::warnock:
        case Procedure::simplest_warnock:
        case Procedure::three_lists_warnock:
        case Procedure::z_buffer:
        case Procedure::weiler_atherton:
        case Procedure::floating_horizon: return {};  // these call, and are not called
    }
    return {};
}

}  // namespace

std::string common_sentence(const event::Call& e, const Words& words) {
    return words.say("{} begins: {}", "Начинается {}: {}", procedure_names[std::size_t(e.of)],
                     words.in(purpose_of(e.of)));
}

std::string common_sentence(const event::Disagree& e, const Words& words) {
    const AnswerWords answer{words};
    return words.say("Decided wrongly: {}. Computed: {}; exact: {}. {}",
                     "Решено неверно: {}. Вычислено: {}; точный ответ: {}. {}",
                     words.in(decision_words[std::size_t(e.of)]), std::visit(answer, e.taken),
                     std::visit(answer, e.exact), words.in(cause_words[std::size_t(e.cause)]));
}

std::string common_note(const event::Disagree& e, const Words& words) {
    const auto answer = [&](const Answer& of) {
        return std::visit(
            [&]<class A>(const A& it) {
                if constexpr (std::same_as<A, bool>) {
                    return text_of(it);
                } else if constexpr (std::same_as<A, int>) {
                    return words.word(it);
                } else {
                    return words.half_open(it.first, it.second);
                }
            },
            of);
    };
    return answer(e.taken) + " ≠ " + answer(e.exact);
}

std::string common_sentence(const event::Fault& e, const Words& words) {
    const auto reason = reason_in(words.language(), e.reason);
    if (!e.x || !e.y) {
        return words.say("The printed text fails here: {}. The run ends.",
                         "Напечатанный текст здесь ошибается: {}. Прогон окончен.", reason);
    }
    return words.say("The printed text fails here, at pixel {}: {}.",
                     "Напечатанный текст здесь, в пикселе {}, ошибается: {}.", words.pair(double(*e.x), double(*e.y)),
                     reason);
}

std::string common_note(const event::Fault& e, const Words& words) {
    return std::string(reason_in(words.language(), e.reason));
}

std::string common_sentence(const event::Plane& e, const PolygonWords& words) {
    return words.say("The plane of {}: (a, b, c, d) = ({}).", "Плоскость {}: (a; b; c; d) = ({}).", e.polygon,
                     words.list({e.plane.begin(), e.plane.end()}));
}

std::string common_note(const event::Plane& e, const PolygonWords& words) {
    return "(" + words.list({e.plane.begin(), e.plane.end()}) + ")";
}

std::string common_sentence(const event::Depth& e, const PolygonWords& words) {
    return words.say("At the point {} the plane of {} has depth {}.", "В точке {} глубина плоскости {} равна {}.",
                     e.point, e.polygon, e.z);
}

std::string common_note(const event::Depth& e, const PolygonWords& words) { return words.word(e.z); }

}  // namespace vidno::say
