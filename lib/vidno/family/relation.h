/// Relation: how a polygon lies to a window.
///
/// A window U is meant without its sides: they are at whole pixels, and the centres by which it is painted are not on them.
/// So what only touches a side from without shows at none of these centres, and is outside; what covers U has all of them,
/// wherever its outline runs, and surrounds it. Of a closed polygon P and U one relation holds:
///
///   outside       P and U have no point in common
///   inside        P lies in U
///   surrounding   U lies in P
///   intersecting  none of these
///
/// Each test decides its part of this; so they agree, and may be exchanged.
#pragma once

#include <array>
#include <string_view>

namespace vidno {

enum class Relation : unsigned char { outside, inside, intersecting, surrounding };
inline constexpr std::array<std::string_view, 4> relation_names{"outside", "inside", "intersecting", "surrounding"};

}  // namespace vidno
