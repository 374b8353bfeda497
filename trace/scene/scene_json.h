/// Scene files, `vidno-scene/1`: reading with every rule checked, and the one form in which scenes are written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "vidno/admitted.h"

namespace vidno {

class JsonNode;

struct SceneWithWarnings {
    AdmittedScene scene;                // a camera is applied already
    std::vector<std::string> warnings;  // what was dropped or cut; each line begins with the file
};

/// `text` is the JSON, `file` is its name in messages. Everything but the vertices has a default: the window is the
/// span of the vertices, a colour comes from the palette. Throws Refused, with a line for each fault.
SceneWithWarnings read_scene(std::string_view text, const std::string& file);

/// Reads a scene inside another document; `file` names that document. Throws Misread.
SceneWithWarnings read_scene(const JsonNode& node, const std::string& file);

/// A scene with everything that its pictures depend on, as in the header of a trace. Throws Misread.
AdmittedScene read_whole_scene(const JsonNode& node);

/// The scene as JSON on one line, always the same bytes; read_scene reads back the same scene.
std::string scene_json(const Scene& scene);

}  // namespace vidno
