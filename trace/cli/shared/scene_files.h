/// Scenes as files of the command line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "choice/kernel_choice.h"
#include "scene/surface.h"

namespace vidno::cli {

/// The scene of a file, of polygons; warnings go to standard error.
Scene scene_from(const std::string& file);
/// The same of its text.
Scene scene_of(std::string_view text, const std::string& file);

/// A scene of polygons or of curves, which must be that of the method, if there is one.
AnyScene any_scene_from(const std::string& file, const std::optional<std::string>& method);

/// The scene as the kernel runs it: snapped for `grid`, which is said on standard error; else as it is.
Scene scene_for(const NamedKernel& kernel, Scene scene, const std::string& file);

}  // namespace vidno::cli
