/// Scenes as files of the command line.
#pragma once

#include <string>
#include <variant>

#include "cli/shared/run_options.h"
#include "scene/failure.h"

namespace vidno::cli {

/// The scene of a file of polygons, or of a failure, which is described on standard error. Warnings go there, too.
AdmittedScene scene_from(const std::string& file);

/// Reads a scene of polygons or of curves.
AnyScene any_scene_from(const std::string& file);

/// Reads the scene of a run. Options that are not given are taken from a failure; the method must suit the scene. With
/// `says_step`, standard error says where the failure is seen.
AnyScene any_scene_for(RunOptions& options, bool says_step = false);

/// Refuses a mesh, by the name of its file: `vidno import` makes a scene of it.
void expect_no_mesh(const std::string& file);

/// Describes a failure on standard error, without its step. Refuses one that has no scene.
void say(const Failure& failure, const std::string& file);

/// The scene of a file for a chart. A surface must be given as a function, because the chart samples it in several
/// ways.
std::variant<AdmittedScene, Function> charted_scene_from(const std::string& file);

/// The scene as the kernel runs it: snapped for `grid`, with a note on standard error; otherwise unchanged.
AdmittedScene scene_for(const NamedKernel& kernel, AdmittedScene scene, const std::string& file);

}  // namespace vidno::cli
