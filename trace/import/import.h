/// Import: a mesh file seen by a camera, as a scene: screen space, admitted polygons, plain colours.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/scene_json.h"
#include "vidno/camera.h"
#include "vidno/scene.h"

namespace vidno {

struct ImportOptions {
    std::optional<Camera> camera;  // by default the whole mesh, y up, a little from above and the right
    int width = 128, height = 128;
    Color background{255, 255, 255};
};

/// `bytes` are the file's contents, `file` is its name, whose extension gives the format: obj, off, ply or stl. A polygon's id is the
/// number of its face, from 0; the parts of a face that had to be cut are 7.1, 7.2, ... Its colour is lighter the more the face turns to
/// the viewer. The warnings report what was read, dropped and cut. Throws Refused.
SceneWithWarnings import_mesh(std::string_view bytes, const std::string& file, const ImportOptions& options);

}  // namespace vidno
