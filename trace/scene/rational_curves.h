/// Curves of a surface in exact arithmetic: their heights, and those of the side edges that join their ends.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "vidno/floating_horizon/curves.h"
#include "vidno/kernels/exact.h"

namespace vidno {

/// The height of the line through two samples on different columns.
inline Rational height_on(const Sample& from, const Sample& to, const Rational& x) {
    return Rational(from.y) + (x - Rational(from.x)) * (Rational(to.y) - Rational(from.y)) / Rational(to.x - from.x);
}

/// The outer ends of a curve's pieces; none if it has no piece.
inline std::optional<std::pair<Sample, Sample>> ends_of(const Curve& curve) {
    const auto pieces = pieces_of(curve);
    if (pieces.empty()) return std::nullopt;
    return std::pair(pieces.front().front(), pieces.back().back());
}

/// The columns first <= x < end over which a side edge hides: those strictly between its ends.
inline std::pair<int, int> columns_of_edge(const Sample& from, const Sample& to) {
    return {std::min(from.x, to.x) + 1, std::max(from.x, to.x)};
}

}  // namespace vidno
