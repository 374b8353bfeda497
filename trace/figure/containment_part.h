/// The containment test of an outline that meets no side of a window.
#pragma once

#include "parts.h"

namespace vidno::figures {

/// For ray crossings: the ray, the points where the edges so far meet its line, and how often each counts. For angles:
/// the octants around the window, and by how many each edge turns. Draws nothing if no containment test is running.
void draw_containment(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

}  // namespace vidno::figures
