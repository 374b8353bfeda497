/// SceneLines: the outlines of a scene's polygons as lines, from the visible regions of Weiler and Atherton's
/// algorithm.
///
/// A line is visible where it bounds a visible region. The algorithm also cuts regions of one polygon from each other,
/// and a face may have been cut into several polygons; such a border is no line of the scene.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "run/run.h"

namespace vidno {

/// A piece of a line in pixels, from its one end to its other.
struct LinePiece {
    std::array<double, 2> from, to;
    bool operator==(const LinePiece&) const = default;
};

/// Pieces that meet in points at most: each place of an outline is in one of them.
struct SceneLines {
    std::vector<LinePiece> visible, hidden;
};

/// The border of a region, without what it shares with other regions of its face.
std::vector<LinePiece> border_of(const std::vector<ShownRegion>& regions, std::size_t region, const Scene& scene);

/// The lines of a scene with these visible regions, computed exactly from the numbers of the regions. An edge-on
/// polygon has none.
SceneLines scene_lines(const std::vector<ShownRegion>& regions, const Scene& scene);

}  // namespace vidno
