/// How an outline that meets no side of a window is found to surround it, or not.
#pragma once

#include "parts.h"

namespace vidno::figures {

/// By ray crossings the ray, and where the edges so far meet its line, how often each counts; by angles the octants around
/// the window, and by how many each edge turns. Nothing, if no outline is gone round.
void draw_containment(Drawing& to, const Moment& moment, const Plane& plane, const Style& style);

}  // namespace vidno::figures
