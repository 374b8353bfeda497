/// Reads a scene file without a tree, which works for most: no camera, ids without escapes, no warnings.
#pragma once

#include <optional>
#include <string_view>

#include "vidno/scene.h"

namespace vidno {

/// The scene that read_scene gives. None for a file with errors or with features that this reader does not know.
std::optional<Scene> read_quickly(std::string_view text);

}  // namespace vidno
