/// The reason of a fault in words.
#pragma once

#include <string_view>

#include "choice/language.h"

namespace vidno {

/// The reasons that a run can give for its fault. A trace has them in English.
inline constexpr Bilingual fault_reasons[] = {
    {"an outline does not close", "контур не замыкается"},
    {"division by zero", "деление на нуль"},
    {"more lists than the lines can divide the area into",
     "списков больше, чем частей, на которые прямые могут разделить область"},
    {"more scanlines than any area has rows", "строк развёртки больше, чем строк в любой области"},
    {"more steps than any area has columns", "шагов больше, чем столбцов в любой области"},
    {"outside the area", "выход за пределы области"},
    {"the last entry of AEL has no partner", "последняя запись AEL осталась без пары"},
    {"the list of vertices is read past its end", "чтение за концом списка вершин"},
};

/// The reason in the language. Those that another program has written remain as they are.
constexpr std::string_view reason_in(Language language, std::string_view reason) {
    for (const auto& known : fault_reasons) {
        if (known.english == reason) return known.in(language);
    }
    return reason;
}

}  // namespace vidno
