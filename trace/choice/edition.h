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
    std::string_view advice{};     // to those whose program makes the mistake; none where students write no such method
};

/// By the places of Edition.
inline constexpr std::array edition_choices{
    EditionChoice{.name = "corrected",
                  .rule = "the procedures with the errors of the printed text put right",
                  .title = {"corrected", "исправленный текст"}},
    EditionChoice{.name = "printed",
                  .rule = "as the course text prints them, errors included",
                  .title = {"as printed", "как напечатано"}},
    EditionChoice{.name = "one-list",
                  .rule = "all parts of a window share one list",
                  .title = {"one list for all parts", "один список на все части"},
                  .only = Method::warnock,
                  .advice = "one APL is shared by all parts of a window: what leaves it in one part is gone in the "
                            "others. Give each part a copy"},
    EditionChoice{.name = "depths-not-cleared",
                  .rule = "Z starts at 0, as a new array does",
                  .title = {"Z not cleared", "Z не очищен"},
                  .only = Method::zbuffer,
                  .advice = "the depths are not cleared: they start at 0, and what lies behind that never shows. Start "
                            "below all depths"},
    EditionChoice{.name = "clip-order-reversed",
                  .rule = "the window's sides are gone round the other way",
                  .title = {"clip order reversed", "обратный порядок отсечения"},
                  .only = Method::warnock,
                  .advice = "the sides of the window are gone round the other way when clipping, so that inside and "
                            "outside are exchanged. Turn the order of its corners or the sign round"},
    EditionChoice{.name = "y-flipped",
                  .rule = "y grows upward: the picture is upside down",
                  .title = {"y flipped", "y перевёрнут"},
                  .advice = "the picture is upside down: y grows downward, row 0 is the uppermost"},
    EditionChoice{.name = "depth-sign-reversed",
                  .rule = "the smaller z is the nearer",
                  .title = {"sign of z reversed", "обратный знак z"},
                  .advice = "the sign of z is reversed: the greater z is the nearer"},
    EditionChoice{.name = "boundary-outside",
                  .rule = "points on the outline count as outside",
                  .title = {"boundary outside", "граница снаружи"},
                  .advice = "points on an outline count as outside of both polygons that share it: pixels there belong "
                            "to nobody. Let a product of 0 count as inside, or give such points to one of the two"},
    EditionChoice{.name = "integer-division",
                  .rule = "the area is halved in whole numbers, and the rest is lost",
                  .title = {"integer division", "деление нацело"},
                  .only = Method::warnock,
                  .advice = "a window is halved in whole numbers: of an odd number of pixels one is lost. Begin with a "
                            "square of 2^m pixels a side that covers the area"},
    EditionChoice{.name = "surround-kept",
                  .rule = "hasSurround is never reset",
                  .title = {"hasSurround never reset", "hasSurround не сбрасывается"},
                  .only = Method::warnock,
                  .advice = "hasSurround is never reset: a polygon that lies before the surrounding one in a part of "
                            "the window is overlooked. Set it to false wherever a nearer polygon is found"},
    EditionChoice{.name = "vertex-counted-twice",
                  .rule = "a ray crosses a vertex twice, whether it is pierced or touched",
                  .title = {"pierced vertex counted twice", "проткнутая вершина за два"},
                  .only = Method::warnock_full},
    EditionChoice{.name = "octants-not-split",
                  .rule = "an edge seen under half of a full angle is not split",
                  .title = {"half angle not split", "развёрнутый угол не разбит"},
                  .only = Method::warnock_angles},
    EditionChoice{.name = "line-for-edge",
                  .rule = "an edge is taken for the whole line on which it lies",
                  .title = {"line taken for edge", "прямая вместо ребра"},
                  .only = Method::warnock_full},
};

constexpr const EditionChoice& choice_of(Edition edition) { return edition_choices[std::size_t(edition)]; }

inline constexpr auto edition_names = [] {
    std::array<std::string_view, edition_choices.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = edition_choices[i].name;
    return names;
}();

}  // namespace vidno
