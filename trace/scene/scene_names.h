/// The names of the course's scenes, charts and maps in each language.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "choice/language.h"

namespace vidno {

inline constexpr auto scene_names = std::to_array<Bilingual>({
    {"A floor and a ramp", "Пол и скат"},
    {"Three quads, each in front of the next", "Три четырёхугольника, каждый перед следующим"},
    {"Three quads, each in front of the next, on 16 × 16 pixels",
     "Три четырёхугольника, каждый перед следующим, на 16 × 16 пикселях"},
    {"Four relations of a polygon to a window", "Четыре отношения многоугольника к окну"},
    {"The triangle behind lies flat", "Задний треугольник параллелен экрану"},
    {"A quad raised in front of the surrounding one", "Четырёхугольник, приподнятый перед охватывающим"},
    {"The corner depths: sufficient, not necessary", "Глубины в углах: достаточно, но не необходимо"},
    {"Down to the pixel", "Вплоть до пикселя"},
    {"An upright square", "Квадрат со сторонами вдоль осей"},
    {"The square, twice as fine", "Квадрат при вдвое большем разрешении"},
    {"The square, four times as fine", "Квадрат при вчетверо большем разрешении"},
    {"The triangle, twice as fine", "Треугольник при вдвое большем разрешении"},
    {"The triangle, four times as fine", "Треугольник при вчетверо большем разрешении"},
    {"An area that is no square", "Неквадратная область"},
    {"Points in, on and outside an outline", "Точки внутри контура, на нём и снаружи"},
    {"One triangle and the windows that clip it", "Один треугольник и окна, которые его отсекают"},
    {"A triangle that keeps seven corners", "Треугольник, от которого остаётся семь вершин"},
    {"Two quads pierce each other", "Два четырёхугольника протыкают друг друга"},
    {"A pentagon and its active edges", "Пятиугольник и его активные рёбра"},
    {"The same plane twice", "Одна плоскость дважды"},
    {"One scene for eight mistakes", "Одна сцена для восьми ошибок"},
    {"Near square in front of a far quad", "Ближний квадрат перед дальним четырёхугольником"},
    {"Three entries in a list of pairs", "Три записи в списке пар"},
    {"An edge within an ulp of a pixel's centre", "Ребро на расстоянии меньше ulp от центра пикселя"},
    {"A board seen from its edge", "Доска, видимая с ребра"},
    {"A box before a pyramid", "Коробка перед пирамидой"},
    {"A square on pixel boundaries", "Квадрат на границах пикселей"},
    {"An edge between vertices very far away", "Ребро между очень далёкими вершинами"},
    {"A ray through vertices and along an edge", "Луч через вершины и вдоль ребра"},
    {"Around a corner of a window, and along its sides", "Вокруг угла окна и вдоль его сторон"},
    {"A shared edge, a touching vertex, edges on an edge", "Общее ребро, касание вершиной, рёбра на ребре"},
    {"A needle between two rows of pixel centres", "Игла между двумя рядами центров пикселей"},
    {"Two triangles that pierce each other, twice as large",
     "Два треугольника протыкают друг друга, сторона вдвое больше"},
    {"Two triangles that pierce each other", "Два треугольника протыкают друг друга"},
    {"A wall that leans, a square before it, a backdrop", "Наклонная стена, квадрат перед ней, фон"},
    {"Two triangles with part of an edge in common, and one before it",
     "Два треугольника с общей частью ребра и один перед ней"},
    {"A vertex that touches an edge", "Вершина, которая касается ребра"},
    {"Four relations of a polygon to a window, on 4 × 4 pixels",
     "Четыре отношения многоугольника к окну на 4 × 4 пикселях"},
    {"Four curves by hand", "Четыре кривые вручную"},
    {"The side of a surface hides", "Бок поверхности заслоняет"},
    {"A peak between two samples", "Пик между двумя отсчётами"},
    {"A peak, turned and tilted", "Пик после поворота и наклона"},
    {"The same, sampled where it bends", "Тот же пик с отсчётами там, где он изгибается"},
    {"A curve that touches the horizon", "Кривая, которая касается горизонта"},
    {"Waves and a pit", "Волны и яма"},
    {"Two walls that are almost one", "Две почти совпадающие стены"},
    {"Four triangles that pierce each other", "Четыре треугольника протыкают друг друга"},
    {"Three million pixels from the origin", "В трёх миллионах пикселей от начала координат"},
    {"A mesh with its vertices on pixel centres", "Сетка с вершинами в центрах пикселей"},
    {"Five triangles of one plane", "Пять треугольников одной плоскости"},
    {"An edge beside the corner (12, 12) of a window: cut at its top, is it left of it",
     "Ребро у угла окна (12; 12): левее ли угла его точка на верхней стороне"},
    {"Two triangles that pass through each other near the diagonal",
     "Два треугольника проходят друг через друга вблизи диагонали"},
    {"The tip of a triangle: the differences of one edge are taken from the tip, those of the other from far away",
     "Вершина треугольника: разности для одного ребра берутся от неё, для другого — от далёкой вершины"},
    {"Kettner, Mehlhorn, Pion, Schirra and Yap 2008, figure 2 (a)",
     "Kettner, Mehlhorn, Pion, Schirra, Yap 2008, рисунок 2 (a)"},
    {"Kettner, Mehlhorn, Pion, Schirra and Yap 2008, figure 2 (b)",
     "Kettner, Mehlhorn, Pion, Schirra, Yap 2008, рисунок 2 (b)"},
    {"Kettner, Mehlhorn, Pion, Schirra and Yap 2008, figure 2 (c)",
     "Kettner, Mehlhorn, Pion, Schirra, Yap 2008, рисунок 2 (c)"},
});

/// The name of a scene in the language. An exercise made from a scene has its name and a number. Other names remain as
/// they are.
inline std::string name_in(Language language, const std::string& name) {
    constexpr std::string_view before_number = " · ";
    const std::size_t end = std::min(name.find(before_number), name.size());
    const auto known = std::find_if(scene_names.begin(), scene_names.end(), [&](const Bilingual& each) {
        return each.english == std::string_view(name).substr(0, end);
    });
    return known == scene_names.end() ? name : std::string(known->in(language)) + name.substr(end);
}

}  // namespace vidno
