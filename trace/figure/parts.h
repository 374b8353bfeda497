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

// What stands on the plane of the scene, one above the other.

/// The pixels painted so far, each colour with a texture of its own, and the lines between them if they are far enough apart.
void draw_picture(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// The area, and the corners' coordinates around it; y grows downward.
void draw_frame(Drawing& to, const Plane& plane);

/// The outlines of the polygons: more than this are a crowd, and faint.
inline constexpr std::size_t most_outlines = 40;
void draw_outlines(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// Warnock: the windows visited, those on the stack dashed, the current one heavy. Z-buffer: the scanline, the active edges.
/// Weiler-Atherton: the lists (weiler_atherton_parts.h).
void draw_windows(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// The windows visited so far, each once.
void draw_visited(Drawing& to, const Moment& moment, const Plane& plane);

/// What the step itself is about: points, pixels, pieces of edges.
void draw_marks(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

struct Pixel {
    int x = 0, y = 0;
};

/// The pixel that is asked about, to be found even where pixels are small.
void draw_chosen(Drawing& to, Pixel pixel, const Plane& plane);

/// The polygons' ids: each, where there is room, in its polygon and in as few others as can be; none overlap.
void draw_names(Drawing& to, const Scene& scene, const Plane& plane, const Style& style);

// What stands beside it.

/// APL with what is known of each polygon in the current window, or AEL. Throws Refused if the trace does not tell it.
Drawing list_part(const Moment& moment, const Style& style, double width);

/// The procedure at hand, its current line marked.
Drawing listing_part(const CallStack::Frame& frame, Edition edition, const Style& style, double width);
Drawing listing_part(const auto& moment, const Style& style, double width) {
    return listing_part(moment.state().calls().back(), moment.header().edition, style, width);
}

}  // namespace vidno::figures
