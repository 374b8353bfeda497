/// The parts of a figure, each made from a moment of a run.
#pragma once

#include <array>
#include <string_view>

#include "drawing.h"
#include "figure_words.h"
#include "moment.h"
#include "plane.h"

namespace vidno::figures {

struct Style {
    Language language = Language::english;
    bool greyscale = false;
    double letters = 1;  // how much wider those of the font are than those of Helvetica
};

// The layers on the plane of the scene, from bottom to top.

/// The pixels painted so far, each colour with its own texture, and the lines between pixels if these are large enough.
void draw_picture(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// The area, and the corners' coordinates around it; y grows downward.
void draw_frame(Drawing& to, const Plane& plane);

/// The outlines of the polygons. More than this many are drawn faint.
inline constexpr std::size_t most_outlines = 40;
void draw_outlines(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// Warnock: the windows visited, those on the stack dashed, the current one heavy. Z-buffer: the scanline, the active
/// edges. Weiler-Atherton: the lists (weiler_atherton_parts.h).
void draw_windows(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// The windows visited so far, each once.
void draw_visited(Drawing& to, const Moment& moment, const Plane& plane);

/// The subject of the step: points, pixels, pieces of edges.
void draw_marks(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// The chosen pixel, visible even where pixels are small.
void draw_chosen(Drawing& to, Pixel pixel, const Plane& plane);

/// The polygons' ids: each, if there is room, in its polygon and in as few others as possible; they do not overlap.
void draw_names(Drawing& to, const Scene& scene, const Plane& plane, const Style& style);

// The parts beside the plane.

/// APL with the known relations of each polygon to the current window, or AEL. Throws Refused if the trace does not
/// contain it.
Drawing list_part(const Moment& moment, const Style& style, double width);

/// The places of corners on the screen, "—" if there are none.
std::string places_of(const std::vector<Corner>& corners, const FigureWords& words);

/// A line of the listings as the edition has it.
std::string text_of(Line at, Edition edition, Language language);

/// The current procedure, with its current line marked.
Drawing listing_part(const CallStack::Frame& frame, Edition edition, const Style& style, double width);
Drawing listing_part(const auto& moment, const Style& style, double width) {
    return listing_part(moment.state().calls().back(), moment.header().edition, style, width);
}

}  // namespace vidno::figures
