/// The window of a scene that names none.
#pragma once

#include <optional>
#include <vector>

#include "vidno/floating_horizon/curves.h"
#include "vidno/scene.h"

namespace vidno {

/// The whole pixels that all vertices reach over, at least one each way. None where there are no vertices, or too many pixels.
std::optional<Area> default_window(const std::vector<ScenePolygon>& polygons);

/// The columns and rows of all samples. None likewise.
std::optional<Area> default_window(const std::vector<Curve>& curves);

}  // namespace vidno
