/// Import: a mesh file seen by a camera, as a scene: screen space, admitted polygons, plain colours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/mesh_soup.h"
#include "loss.h"
#include "vidno/admitted.h"
#include "vidno/camera.h"
#include "vidno/scene.h"

namespace vidno {

struct ImportOptions {
    std::optional<Camera> camera;  // by default the whole mesh, y up, a little from above and the right
    int width = 128, height = 128;
    Color background{255, 255, 255};
};

struct ImportedScene {
    AdmittedScene scene;
    std::string report;        // what was read, dropped and cut; begins with the file
    std::vector<Loss> losses;  // what the scene lacks
};

/// `bytes` are the file's contents, `file` is its name, whose extension gives the format: obj, off, ply or stl.
/// `beside` reads the files that it names, such as libraries of materials. A polygon's id is the number of its face,
/// from 0, after the name of its group, "wing:7"; the parts of a face that had to be cut are 7.1, 7.2, ... Its colour
/// is that of the file; without one, it is lighter the more the face turns to the viewer. Throws Refused.
ImportedScene import_mesh(std::string_view bytes, const std::string& file, const ImportOptions& options,
                          const Beside& beside = {});

/// Reads the files beside this one.
Beside files_beside(const std::string& file);

/// Reads the file here, with the files beside it, and imports it.
ImportedScene import_mesh_file(const std::string& file, const ImportOptions& options);

}  // namespace vidno
