/// Edition: which text of the procedures is run, by its name.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace vidno {

enum class Edition : unsigned char { corrected, printed };

struct EditionChoice {
    std::string_view name;
    std::string_view rule;
};

/// By the places of Edition.
inline constexpr std::array edition_choices{
    EditionChoice{"corrected", "the procedures with the errors of the printed text put right"},
    EditionChoice{"printed", "as the course text prints them, errors included"},
};

inline constexpr auto edition_names = [] {
    std::array<std::string_view, edition_choices.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = edition_choices[i].name;
    return names;
}();

}  // namespace vidno
