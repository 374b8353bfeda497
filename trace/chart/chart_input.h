/// Reading charts, for their figures.
#pragma once

#include <variant>

#include "chart/chart.h"
#include "chart/surface_chart.h"

namespace vidno {

/// A chart is of scenes or of surfaces.
using AnyChart = std::variant<std::vector<SceneChart>, std::vector<SurfaceChart>>;

/// Reads what chart_json wrote. `file` is its name in messages. Throws Refused.
AnyChart read_chart(std::string_view text, const std::string& file);

}  // namespace vidno
