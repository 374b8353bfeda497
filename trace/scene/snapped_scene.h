/// The scene that the kernel `grid` runs, and the changes that snapping made.
#pragma once

#include <string>

#include "vidno/admitted.h"
#include "vidno/resolution.h"

namespace vidno {

struct SnappedScene {
    AdmittedScene scene;               // the triangles that a polygon was cut into have its id and a number
    std::vector<std::size_t> sources;  // for each polygon, the one that it was made from
    Snapping snapping;

    /// The changes in words, "moved 5 of 12 vertices, ..."; empty if there are none.
    std::string change() const;
};

/// The most bits of a grid that the kernel's numbers can hold for the scene; 0 if they hold none.
int finest_grid_of(const Scene& scene);

/// Throws Refused if the kernel's numbers cannot hold the scene.
SnappedScene snapped_scene(const AdmittedScene& scene, int bits);

}  // namespace vidno
