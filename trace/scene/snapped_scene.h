/// The scene that the kernel `grid` runs, and what was changed to make it.
#pragma once

#include <string>

#include "vidno/resolution.h"

namespace vidno {

struct SnappedScene {
    Scene scene;                       // the triangles that a polygon was cut into have its id and a number
    std::vector<std::size_t> sources;  // of each polygon, which it was
    Snapping snapping;

    /// In words, "moved 5 of 12 vertices, ..."; empty if nothing changed.
    std::string change() const;
};

/// The most bits of a grid that the kernel's numbers would hold; 0: none do.
int finest_grid_of(const Scene& scene);

/// Throws Refused if the kernel's numbers would not hold it.
SnappedScene snapped_scene(const Scene& scene, int bits);

}  // namespace vidno
