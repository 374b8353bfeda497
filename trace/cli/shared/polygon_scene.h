/// The scene of a run for commands that take polygons alone.
#pragma once

#include <utility>
#include <variant>

#include "cli/shared/scene_files.h"
#include "refused.h"

namespace vidno::cli {

/// As any_scene_for: options that are not given are taken from a failure. Refuses a surface.
inline AdmittedScene polygon_scene_for(RunOptions& options) {
    AnyScene any = any_scene_for(options);
    if (auto* scene = std::get_if<AdmittedScene>(&any)) return std::move(*scene);
    throw Refused(options.scene + ": a surface, but this command takes scenes of polygons, vidno-scene/1");
}

}  // namespace vidno::cli
