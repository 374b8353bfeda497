/// The colours of polygons that name none.
#pragma once

#include <array>
#include <cstddef>

#include "vidno/scene.h"

namespace vidno {

/// Colours that stay apart for colour-blind eyes and in grey.
///
/// Source  M. Okabe and K. Ito, Color universal design, 2008.
inline constexpr std::array<Color, 7> palette{{{0xe6, 0x9f, 0x00},
                                               {0x00, 0x72, 0xb2},
                                               {0xd5, 0x5e, 0x00},
                                               {0x56, 0xb4, 0xe9},
                                               {0x00, 0x9e, 0x73},
                                               {0xcc, 0x79, 0xa7},
                                               {0xf0, 0xe4, 0x42}}};

/// The colour of the polygon at this place of its scene, if it names none.
constexpr Color default_color(std::size_t place) { return palette[place % palette.size()]; }

}  // namespace vidno
