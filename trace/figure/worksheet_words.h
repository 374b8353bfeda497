/// The words of worksheets.
#pragma once

#include <string_view>

#include "figure_words.h"

namespace vidno::figures {

struct WorksheetWords {
    std::string_view name, date, key, page;
    std::string_view scene, vertices, planes, depth_rule, factor;
    std::string_view quadtree;
    std::string_view windows, number, window, decision, painted, legend, decisions, background;
    std::string_view family_legend, family_decisions;
    std::string_view edges, row, pixels, edges_legend;
    std::string_view regions, lists, clip, list, inside, outside, nearer, result, visible, again, lists_legend;
    std::string_view raster, raster_of_names;
    std::string_view curves, height_rule, grid, upper, lower;
    std::string_view by_columns, curve, flag, meets, flags_legend, meets_legend, sides_legend;
    std::string_view rows_here;  // stands before a number
};

inline constexpr InEachLanguage<WorksheetWords> worksheet_words{
    {
        .name = "Name",
        .date = "Date",
        .key = "Answer key",
        .page = "page",
        .scene = "The scene",
        .vertices = "Vertices",
        .planes = "Planes a x + b y + c z + d = 0",
        .depth_rule = "The greater z is the nearer; y grows downward.",
        .factor = "Or the same with a common factor.",
        .quadtree = "Quadtree: draw the windows",
        .windows = "Windows, in the order in which they are taken from AW",
        .number = "No.",
        .window = "(x, y) w × h",
        .decision = "decision",
        .painted = "painted",
        .legend =
            "For each polygon: − leaves the APL (PW3), S surrounds, + neither; then k (PW6). Painted: which polygon; 0 "
            "is background.",
        .decisions = "Decisions: W7 empty, W8 surrounded, W9 pixel, W10 single, W13 split.",
        .background = "0",
        .family_legend = "For each polygon examined in the window: − outside, I inside, + intersecting, S surrounding. "
                         "Painted: which "
                         "polygon; 0 is background.",
        .family_decisions = "Decisions: empty, surrounded, pixel, single, split, each with its line.",
        .edges = "Rows and their AEL",
        .row = "row",
        .pixels = "pixels",
        .edges_legend = "An entry: x, z, last row y, Δx, Δz. Pixels: first to last. A level edge is in no AEL (Z9).",
        .regions = "Visible regions: draw them, each with its polygon",
        .lists = "Lists, in the order in which they are taken from the stack",
        .clip = "C",
        .list = "list L",
        .inside = "inside C",
        .outside = "outside C",
        .nearer = "not behind C",
        .result = "result",
        .visible = "C visible",
        .again = "again",
        .lists_legend = "Polygons by their names. Again: the parts not behind C, and C as the last, are the next list.",
        .raster = "Polygon and depth of each pixel at the end",
        .raster_of_names = "Polygon of each pixel at the end",
        .curves = "The curves, the nearest first, with their samples (x, y)",
        .height_rule =
            "Between its samples a curve is straight. The axis y points downward: the smaller y is the higher.",
        .grid = "Draw the visible parts of the curves; at the end, draw both horizons",
        .upper = "upper",
        .lower = "lower",
        .by_columns = "The curves over the columns x: y, flag, and both horizons after the curve",
        .curve = "curve",
        .flag = "flag",
        .meets = "meets",
        .flags_legend =
            "Flag: 1 on the upper horizon or above it, −1 on the lower one or below it, ±1 on both or where "
            "there are none, 0 hidden.",
        .meets_legend = "Meets: the points (x, y) where the curve's visible parts begin or end at a horizon of the "
                        "curves before it.",
        .sides_legend = "The side edges between the ends of neighbouring curves count, too: the left one before the "
                        "curve, the right one after it.",
        .rows_here = "The run goes on; rows in the table:",
    },
    {
        .name = "Фамилия",
        .date = "Дата",
        .key = "Ответы",
        .page = "с.",
        .scene = "Сцена",
        .vertices = "Вершины",
        .planes = "Плоскости a x + b y + c z + d = 0",
        .depth_rule = "Чем больше z, тем ближе; ось y направлена вниз.",
        .factor = "Или то же с общим множителем.",
        .quadtree = "Дерево квадрантов: начертите окна",
        .windows = "Окна в том порядке, в котором они берутся из AW",
        .number = "№",
        .window = "(x; y) w × h",
        .decision = "решение",
        .painted = "цвет",
        .legend =
            "Для многоугольника: − удалён из APL (PW3), S охватывает, + ни то ни другое; затем k (PW6). Цвет: чей; "
            "0 — фон.",
        .decisions = "Решения: W7 пустое, W8 охвачено, W9 пиксель, W10 один, W13 делится.",
        .background = "0",
        .family_legend =
            "Для многоугольника, проверенного в окне: − вне, I внутри, + пересекает, S охватывает. Цвет: чей; 0 — фон.",
        .family_decisions = "Решения: пустое, охвачено, пиксель, один, делится; у каждого его строка.",
        .edges = "Строки и их AEL",
        .row = "строка",
        .pixels = "пиксели",
        .edges_legend =
            "Запись: x, z, последняя строка y, Δx, Δz. Пиксели: от и до. Горизонтальное ребро в AEL не входит (Z9).",
        .regions = "Видимые области: начертите их и подпишите",
        .lists = "Списки в том порядке, в котором они берутся из стека",
        .clip = "C",
        .list = "список L",
        .inside = "внутри C",
        .outside = "вне C",
        .nearer = "не позади C",
        .result = "итог",
        .visible = "C виден",
        .again = "ещё раз",
        .lists_legend = "Многоугольники по именам. Ещё раз: следующий список — части не позади C, последним сам C.",
        .raster = "Многоугольник и глубина каждого пикселя в конце",
        .raster_of_names = "Многоугольник каждого пикселя в конце",
        .curves = "Кривые, начиная с ближней, и их отсчёты (x; y)",
        .height_rule = "Между отсчётами кривая прямая. Ось y направлена вниз: чем меньше y, тем выше.",
        .grid = "Начертите видимые части кривых, в конце — оба горизонта",
        .upper = "верхний",
        .lower = "нижний",
        .by_columns = "Кривые над столбцами x: y, флаг и оба горизонта после кривой",
        .curve = "кривая",
        .flag = "флаг",
        .meets = "встречи",
        .flags_legend = "Флаг: 1 — на верхнем горизонте или выше, −1 — на нижнем или ниже, ±1 — на обоих или где "
                        "горизонтов нет, 0 — скрыта.",
        .meets_legend = "Встречи: точки (x; y), где видимые части кривой начинаются или кончаются на горизонте "
                        "предыдущих кривых.",
        .sides_legend =
            "Боковые рёбра между концами соседних кривых тоже учитываются: левое до кривой, правое после неё.",
        .rows_here = "Прогон продолжается; строк в таблице:",
    },
};

constexpr const WorksheetWords& worksheet_words_of(Language language) { return worksheet_words.in(language); }

}  // namespace vidno::figures
