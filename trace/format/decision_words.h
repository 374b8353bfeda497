/// What a decision is about, in words: for the answers of failures, and for the page.
#pragma once

#include <array>

#include "choice/language.h"
#include "format/verdict.h"

namespace vidno {

/// For the middle of a sentence, in the order of Decision.
inline constexpr std::array<Bilingual, decision_names.size()> decision_words{{
    {"the result of a comparison of two numbers", "итог сравнения двух чисел"},
    {"on which side of the line the point lies", "по какую сторону прямой лежит точка"},
    {"whether the depth is nearer", "ближе ли глубина"},
    {"whether the box lies outside the window", "лежит ли габаритный прямоугольник вне окна"},
    {"whether the box lies inside the window", "лежит ли габаритный прямоугольник внутри окна"},
    {"the first pixel", "первый пиксель"},
    {"the last pixel", "последний пиксель"},
    {"the rows", "строки"},
    {"the columns", "столбцы"},
    {"whether two numbers round alike", "одинаково ли округляются два числа"},
    {"the pixel of a number", "пиксель, в который попадает число"},
    {"the flag of Visibility", "флаг видимости"},
    {"whether the point lies left of the edge", "лежит ли точка слева от ребра"},
    {"whether the two are parallel", "параллельны ли прямые или плоскости"},
}};

/// Why a decision is wrong, in the order of Cause.
inline constexpr std::array<Bilingual, cause_names.size()> cause_words{{
    {"This operation rounded.", "Погрешность округления в этой операции."},
    {"Correct for its operands, which had already drifted.",
     "Для своих операндов верно: погрешность накоплена раньше."},
}};

}  // namespace vidno
