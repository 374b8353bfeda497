/// RegionOutput: visible regions as a file, `vidno-regions/1`.
#pragma once

#include <string>
#include <vector>

#include "run/run.h"

namespace vidno {

/// The regions of a scene's run as JSON; FORMAT.md describes it.
std::string regions_json(const std::vector<ShownRegion>& regions, const RunRequest& request);

}  // namespace vidno
