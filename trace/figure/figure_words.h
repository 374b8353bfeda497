/// The words of figures, in the terms of the page.
#pragma once

#include <array>
#include <string_view>

#include "choice/language.h"
#include "vidno/trace.h"

namespace vidno::figures {

struct FigureWords {
    std::string_view step, start, stack, active_polygons, surrounds, nearer_at, corner_depths;
    std::string_view active_edges, edge, until;
    std::string_view current_list, vertices, behind_all, inside, outside, enters, leaves;
    std::string_view pixel, line, what, answer, painted;
    std::string_view empty, more, earlier, yes, no;
    std::string_view computed, right, wrong;
    std::array<std::string_view, 4> corners,
        all_but;  // indexed by Corner: their places on the screen, and all but this one
    std::string_view all_corners;
    std::array<std::string_view, case_names.size()> cases;  // of a window
};

inline constexpr InEachLanguage<FigureWords> figure_words{
    {
        .step = "step",
        .start = "the run begins",
        .stack = "on the stack",
        .active_polygons = "Active polygons (APL)",
        .surrounds = "surrounds",
        .nearer_at = "nearer at",
        .corner_depths = "nearest z at the corners",
        .active_edges = "Active edges (AEL)",
        .edge = "edge",
        .until = "until",
        .current_list = "List L, C first",
        .vertices = "vertices",
        .behind_all = "behind all",
        .inside = "inside",
        .outside = "outside",
        .enters = "enters C",
        .leaves = "leaves C",
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
        .corners = {"upper left", "lower left", "upper right", "lower right"},
        .all_but = {"all but upper left", "all but lower left", "all but upper right", "all but lower right"},
        .all_corners = "all four",
        .cases = {"empty", "surrounded", "pixel", "single", "split"},
    },
    {
        .step = "шаг",
        .start = "начало прогона",
        .stack = "в стеке",
        .active_polygons = "Активные многоугольники (APL)",
        .surrounds = "охватывает",
        .nearer_at = "ближе в углах",
        .corner_depths = "наибольшие z в углах",
        .active_edges = "Активные рёбра (AEL)",
        .edge = "ребро",
        .until = "до",
        .current_list = "Список L, первый C",
        .vertices = "вершины",
        .behind_all = "позади всех",
        .inside = "внутри",
        .outside = "снаружи",
        .enters = "вход в C",
        .leaves = "выход из C",
        .pixel = "Пиксель",
        .line = "строка",
        .what = "что найдено",
        .answer = "для пикселя",
        .painted = "закрашен",
        .empty = "пусто",
        .more = "ещё",
        .earlier = "раньше:",
        .yes = "да",
        .no = "нет",
        .computed = "вычислено",
        .right = "верно",
        .wrong = "неверно",
        .corners = {"левый верхний", "левый нижний", "правый верхний", "правый нижний"},
        .all_but = {"все, кроме левого верхнего", "все, кроме левого нижнего", "все, кроме правого верхнего",
                    "все, кроме правого нижнего"},
        .all_corners = "все четыре",
        .cases = {"пустое", "охвачено", "пиксель", "один", "делится"},
    },
};

constexpr const FigureWords& words_of(Language language) { return figure_words.in(language); }

/// The decisions of a map and their answers. The English words are their names.
inline constexpr auto map_words = std::to_array<Bilingual>({
    {"orientation", "ориентация"},
    {"surround", "охват"},
    {"clip", "отсечение"},
    {"depth", "глубина"},
    {"negative", "отрицательно"},
    {"zero", "нуль"},
    {"positive", "положительно"},
    {"outside", "снаружи"},
    {"inside", "внутри"},
    {"nearer", "ближе"},
    {"not nearer", "не ближе"},
});

constexpr std::string_view map_word_in(Language language, std::string_view name) {
    for (const auto& word : map_words) {
        if (word.english == name) return word.in(language);
    }
    return name;
}

}  // namespace vidno::figures
