/// The parts of a figure of a run of Weiler and Atherton's algorithm.
#pragma once

#include "parts.h"
#include "regions/scene_lines.h"
#include "run/run.h"

namespace vidno::figures {

/// The visible regions alone, as wide as a column of a journal.
Drawing drawn_regions(const std::vector<ShownRegion>& regions, const Scene& scene);

/// The lines of the scene alone: the visible ones solid, the hidden ones dashed or omitted.
enum class HiddenLines : unsigned char { dashed, omitted };
Drawing drawn_lines(const SceneLines& lines, HiddenLines hidden, const Scene& scene);

// The layers on the plane of the scene, from bottom to top.

/// The visible regions found so far, filled.
void draw_visible(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// The lists on the stack, dotted. In the current list: the clip polygon heavy, the parts inside it solid, those
/// outside dashed.
void draw_lists(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

/// A region on the plane; nothing if a vertex is not finite.
std::vector<Polyline> loops_of(const RegionLoops& region, const Plane& plane);

// The parts beside the plane.

/// The polygons of the current list, and the part (inside, outside) that holds each.
Drawing region_list(const Moment& moment, const Style& style, double width);

}  // namespace vidno::figures
