/// Edition: which text of the procedures is run, by its name.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

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
    std::optional<Method> only{};  // the method that it concerns; none: each
};

/// By the places of Edition.
inline constexpr std::array edition_choices{
    EditionChoice{"corrected", "the procedures with the errors of the printed text put right"},
    EditionChoice{"printed", "as the course text prints them, errors included"},
    EditionChoice{"one-list", "all parts of a window share one list", Method::warnock},
    EditionChoice{"depths-not-cleared", "Z starts at 0, as a new array does", Method::zbuffer},
    EditionChoice{"clip-order-reversed", "the window's sides are gone round the other way", Method::warnock},
    EditionChoice{"y-flipped", "y grows upward: the picture is upside down"},
    EditionChoice{"depth-sign-reversed", "the smaller z is the nearer"},
    EditionChoice{"boundary-outside", "points on the outline count as outside"},
    EditionChoice{"integer-division", "the area is halved in whole numbers, and the rest is lost", Method::warnock},
    EditionChoice{"surround-kept", "hasSurround is never reset", Method::warnock},
    EditionChoice{"vertex-counted-twice", "a ray crosses a vertex twice, whether it is pierced or touched",
                  Method::warnock_full},
    EditionChoice{"octants-not-split", "an edge seen under half of a full angle is not split", Method::warnock_angles},
    EditionChoice{"line-for-edge", "an edge is taken for the whole line on which it lies", Method::warnock_full},
};

constexpr const EditionChoice& choice_of(Edition edition) { return edition_choices[std::size_t(edition)]; }

inline constexpr auto edition_names = [] {
    std::array<std::string_view, edition_choices.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = edition_choices[i].name;
    return names;
}();

}  // namespace vidno
