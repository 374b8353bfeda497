/// CorrectedPolygons: what all methods for polygons share: how they read polygons from the scene, and their depths. It
/// is part of the sets in corrected.h and corrected_weiler_atherton.h.
#pragma once

#include "warnock/depth.h"
#include "warnock/initialize_polygon.h"

namespace vidno {

struct CorrectedPolygons : InitializePolygon, Depth {
    /// W2: does a polygon join the first list? Admission has already decided exactly whether it is edge-on.
    static bool takes_part(const auto&, const auto& polygon) { return !polygon.edge_on; }

    /// I1: a vertex of the scene on the screen: y grows downward in both.
    static auto on_screen(const auto& kernel, const Area&, const glm::dvec3& vertex) { return kernel.vertex(vertex); }
};

}  // namespace vidno
