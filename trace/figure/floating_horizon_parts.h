/// The parts of a figure of a run of curves.
#pragma once

#include <vector>

#include "floating_horizon_moment.h"
#include "loss.h"
#include "parts.h"
#include "plane.h"

namespace vidno::figures {

/// The visible lines alone, as wide as a column of a journal.
Drawing drawn_lines(const DrawnLines& lines, const Area& area);

/// The curves that the visible part of the plane, as in `drawn_lines` or in a figure, does not show whole.
std::vector<Loss> cut_curves(const DrawnLines& lines, const Plane& plane);

// The layers on the plane of the scene, from bottom to top.

/// The visible lines so far, `width` points wide.
void draw_lines(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane, double width = 0.5);

/// Both horizons, `width` points wide: the upper one with long dashes, the lower one with short ones.
void draw_horizons(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane, const Style& style,
                   double width = 1);

/// The current curve with its samples, the current segment heavy; the examined column, and the subject of the step.
void draw_curve_at_hand(Drawing& to, const FloatingHorizonMoment& moment, const Plane& plane, const Style& style);

/// The samples of two dashed lines with the names of the horizons. Returns where the next thing may stand.
double add_horizon_names(Drawing& to, std::string_view upper, std::string_view lower, const Style& style);

/// A line below the plane, in the listing's own words: which horizon is which, and the result of Visibility.
inline constexpr double legend_height = 4.2;
Drawing curve_legend(const FloatingHorizonMoment& moment, const Style& style, double width);

}  // namespace vidno::figures
