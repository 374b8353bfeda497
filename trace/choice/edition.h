/// Edition: which text of the procedures is run, by its name.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "choice/bilingual.h"
#include "vidno/method.h"

namespace vidno {

/// Corrected, as printed, or with one usual mistake.
enum class Edition : unsigned char {
    corrected,
    printed,
    one_list,
    depths_not_cleared,
    clip_order_reversed,
    y_flipped,
    depth_sign_reversed,
    boundary_outside,
    integer_division,
    surround_kept,
    vertex_counted_twice,
    octants_not_split,
    line_for_edge
};

constexpr bool is_mistake(Edition edition) { return edition > Edition::printed; }

struct EditionChoice {
    std::string_view name;
    std::string_view rule;
    Bilingual title;               // on the page; of a mistake, what it is
    std::optional<Method> only{};  // the method that it concerns; none: each
};

/// By the places of Edition.
inline constexpr std::array edition_choices{
    EditionChoice{"corrected",
                  "the procedures with the errors of the printed text put right",
                  {"corrected", "исправленный текст"}},
    EditionChoice{"printed", "as the course text prints them, errors included", {"as printed", "как напечатано"}},
    EditionChoice{"one-list",
                  "all parts of a window share one list",
                  {"one list for all parts", "один список на все части"},
                  Method::warnock},
    EditionChoice{
        "depths-not-cleared", "Z starts at 0, as a new array does", {"Z not cleared", "Z не очищен"}, Method::zbuffer},
    EditionChoice{"clip-order-reversed",
                  "the window's sides are gone round the other way",
                  {"clip order reversed", "обратный порядок отсечения"},
                  Method::warnock},
    EditionChoice{"y-flipped", "y grows upward: the picture is upside down", {"y flipped", "y перевёрнут"}},
    EditionChoice{"depth-sign-reversed", "the smaller z is the nearer", {"sign of z reversed", "обратный знак z"}},
    EditionChoice{
        "boundary-outside", "points on the outline count as outside", {"boundary outside", "граница снаружи"}},
    EditionChoice{"integer-division",
                  "the area is halved in whole numbers, and the rest is lost",
                  {"integer division", "деление нацело"},
                  Method::warnock},
    EditionChoice{"surround-kept",
                  "hasSurround is never reset",
                  {"hasSurround never reset", "hasSurround не сбрасывается"},
                  Method::warnock},
    EditionChoice{"vertex-counted-twice",
                  "a ray crosses a vertex twice, whether it is pierced or touched",
                  {"pierced vertex counted twice", "проткнутая вершина за два"},
                  Method::warnock_full},
    EditionChoice{"octants-not-split",
                  "an edge seen under half of a full angle is not split",
                  {"half angle not split", "развёрнутый угол не разбит"},
                  Method::warnock_angles},
    EditionChoice{"line-for-edge",
                  "an edge is taken for the whole line on which it lies",
                  {"line taken for edge", "прямая вместо ребра"},
                  Method::warnock_full},
};

constexpr const EditionChoice& choice_of(Edition edition) { return edition_choices[std::size_t(edition)]; }

inline constexpr auto edition_names = [] {
    std::array<std::string_view, edition_choices.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = edition_choices[i].name;
    return names;
}();

}  // namespace vidno
