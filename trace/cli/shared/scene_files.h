/// Scenes as files of the command line.
#pragma once

#include <string>
#include <string_view>

#include "cli/shared/run_options.h"
#include "scene/failure.h"

namespace vidno::cli {

/// The scene of a file, of polygons, or of a failure, about which standard error says what it is; warnings go there, too.
Scene scene_from(const std::string& file);
/// The same of its text.
Scene scene_of(std::string_view text, const std::string& file);

/// A scene of polygons or of curves, likewise.
AnyScene any_scene_from(const std::string& file);

/// The same for a run. What the options do not say, they take from a failure; the method must be one for the scene. With
/// `says_step`, standard error says where the failure is seen.
AnyScene any_scene_for(RunOptions& options, bool says_step = false);

/// On standard error what a failure is about, but for its step. Refuses one that has no scene.
void say(const Failure& failure, const std::string& file);

/// The text of a scene or surface file, or that of the scene of a failure.
std::string scene_text_in(const std::string& file);

/// The scene as the kernel runs it: snapped for `grid`, which is said on standard error; else as it is.
Scene scene_for(const NamedKernel& kernel, Scene scene, const std::string& file);

}  // namespace vidno::cli
