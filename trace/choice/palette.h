/// The colours of polygons without a colour of their own.
#pragma once

#include <array>
#include <cstddef>

#include "vidno/scene.h"

namespace vidno {

/// Colours that colour-blind people can distinguish, also in grey.
///
/// Source  M. Okabe and K. Ito, Color universal design, 2008.
inline constexpr std::array<Color, 7> palette{{{0xe6, 0x9f, 0x00},
                                               {0x00, 0x72, 0xb2},
                                               {0xd5, 0x5e, 0x00},
                                               {0x56, 0xb4, 0xe9},
                                               {0x00, 0x9e, 0x73},
                                               {0xcc, 0x79, 0xa7},
                                               {0xf0, 0xe4, 0x42}}};

/// The colour of the polygon with this index in its scene, if it has none of its own.
constexpr Color default_color(std::size_t place) { return palette[place % palette.size()]; }

}  // namespace vidno
