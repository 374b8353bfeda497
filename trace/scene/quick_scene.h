/// A scene file read without a tree, as most are: no camera, ids without escapes, nothing to warn of.
#pragma once

#include <optional>
#include <string_view>

#include "vidno/scene.h"

namespace vidno {

/// The scene as read_scene gives it. None for a file that is wrong or has more than this reader knows.
std::optional<Scene> read_quickly(std::string_view text);

}  // namespace vidno
