/// The parts of a figure of a run of curves.
#pragma once

#include "floating_horizon_moment.h"
#include "parts.h"

namespace vidno::figures {

/// The visible lines alone, as wide as a column of a journal.
Drawing drawn_lines(const DrawnLines& lines, const Area& area);

// What stands on the plane of the scene, one above the other.

/// The visible lines so far.
void draw_lines(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane);

/// Both horizons: the upper one long dashes, the lower one short.
void draw_horizons(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane, const Style& style);

/// The curve at hand with its samples, heavy the segment at hand; the column that is looked at, and what the step is about.
void draw_curve_at_hand(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane, const Style& style);

/// What stands below the plane, a line in the listing's own words: which horizon is which, and what Visibility said.
inline constexpr double legend_height = 4.2;
Drawing curve_legend(const FloatingHorizonMoment& moment, const Style& style, double width);

}  // namespace vidno::figures
