/// The words of figures, in the terms of the page.
#pragma once

#include <array>
#include <string_view>

#include "choice/language.h"

namespace vidno::figures {

struct FigureWords {
    std::string_view step, stack, active_polygons, surrounds, nearer_at, corner_depths;
    std::string_view active_edges, edge, until;
    std::string_view list_in_hand, vertices, behind_all, inside, outside;
    std::string_view pixel, line, what, answer, painted;
    std::string_view empty, more, earlier, yes, no;
    std::string_view computed, right, wrong;
};

inline constexpr InEachLanguage<FigureWords> figure_words{
    {
        .step = "step",
        .stack = "on the stack",
        .active_polygons = "Active polygons (APL)",
        .surrounds = "surrounds",
        .nearer_at = "nearer at",
        .corner_depths = "nearest z at the corners",
        .active_edges = "Active edges (AEL)",
        .edge = "edge",
        .until = "until",
        .list_in_hand = "List L, C first",
        .vertices = "vertices",
        .behind_all = "behind all",
        .inside = "inside",
        .outside = "outside",
        .pixel = "Pixel",
        .line = "line",
        .what = "what was found",
        .answer = "for the pixel",
        .painted = "painted",
        .empty = "empty",
        .more = "more",
        .earlier = "earlier:",
        .yes = "yes",
        .no = "no",
        .computed = "computed",
        .right = "right",
        .wrong = "wrong",
    },
    {
        .step = "шаг",
        .stack = "в стеке",
        .active_polygons = "Активные многоугольники (APL)",
        .surrounds = "охватывает",
        .nearer_at = "ближе в углах",
        .corner_depths = "наибольшие z в углах",
        .active_edges = "Активные рёбра (AEL)",
        .edge = "ребро",
        .until = "до",
        .list_in_hand = "Список L, первый C",
        .vertices = "вершины",
        .behind_all = "сзади всех",
        .inside = "внутри",
        .outside = "снаружи",
        .pixel = "Пиксель",
        .line = "строка",
        .what = "что найдено",
        .answer = "для пикселя",
        .painted = "окрашен",
        .empty = "пусто",
        .more = "ещё",
        .earlier = "раньше:",
        .yes = "да",
        .no = "нет",
        .computed = "вычислено",
        .right = "верно",
        .wrong = "неверно",
    },
};

constexpr const FigureWords& words_of(Language language) { return figure_words.in(language); }

/// The answers of a map. The English ones are their names.
inline constexpr auto map_answers = std::to_array<Bilingual>({
    {"negative", "отрицательно"},
    {"zero", "нуль"},
    {"positive", "положительно"},
    {"outside", "снаружи"},
    {"inside", "внутри"},
    {"nearer", "ближе"},
    {"not nearer", "не ближе"},
});

constexpr std::string_view answer_in(Language language, std::string_view name) {
    for (const auto& answer : map_answers) {
        if (answer.english == name) return answer.in(language);
    }
    return name;
}

}  // namespace vidno::figures
