/// What a scene may leave out: members with a default, and its window.
#pragma once

#include <optional>
#include <vector>

#include "vidno/floating_horizon/curves.h"
#include "vidno/scene.h"

namespace vidno {

/// Whether members with a default may be left out; they may not in the header of a trace.
enum class Defaults { taken, none };

/// The whole pixels that the vertices span, at least one in each direction. None if there are no vertices, or too many
/// pixels.
std::optional<Area> default_window(const std::vector<ScenePolygon>& polygons);

/// The columns of all samples and the rows of their points; none in the same cases.
std::optional<Area> default_window(const std::vector<Curve>& curves);

}  // namespace vidno
