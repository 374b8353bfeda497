/// Relation: how a polygon lies in relation to a window.
///
/// A window U excludes its sides: they lie at whole pixels, and the centres by which it is painted are not on them. A
/// polygon that only touches a side from outside shows at none of these centres and is outside. A polygon that covers U
/// contains all of them, wherever its outline runs, and surrounds U. Exactly one relation holds between a closed
/// polygon P and U:
///
///   outside       P and U have no point in common
///   inside        P lies in U
///   surrounding   U lies in P
///   intersecting  none of these
///
/// The tests follow these definitions, so they agree and may be exchanged.
#pragma once

#include <array>
#include <string_view>

namespace vidno {

enum class Relation : unsigned char { outside, inside, intersecting, surrounding };
inline constexpr std::array<std::string_view, 4> relation_names{"outside", "inside", "intersecting", "surrounding"};

}  // namespace vidno
