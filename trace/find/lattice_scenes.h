/// Random scenes with small numbers, and random changes of scenes, for a search.
///
/// Areas begin at (0, 0). Polygons are called A, B, C by their order, and each has its own colour.
#pragma once

#include <optional>

#include "scene/families.h"
#include "vidno/admitted.h"

namespace vidno {

/// How large and how fine a scene may be.
struct Lattice {
    int widest = 2;         // side of the area
    int most_polygons = 1;  // at most 7
    int places = 1;         // binary, of x and y
    int depth_places = 2;   // binary, of z
    int greatest = 0;       // number of units of a coordinate; 0: as the area demands
    bool is_coarse = true;  // no scene of the families, and no change by ulps

    /// The larger the number, the larger and finer; from 0.
    static Lattice of_growth(int growth);
};

/// Polygons that have something to do with each other: flat and tilted ones, some in one plane, some with a common
/// edge, some edge-on, some over the whole area; or now and then a scene of the families. None if what was drawn is not
/// admitted.
std::optional<AdmittedScene> lattice_scene(RandomPolygons& random, const Lattice& lattice);

/// A tetrahedron; its outlines are counter-clockwise as seen from outside, or all of them clockwise.
std::optional<AdmittedScene> random_body(RandomPolygons& random, const Lattice& lattice);

/// The scene with one change, or a few: of the area, a polygon or a coordinate. None if what was drawn is not admitted.
std::optional<AdmittedScene> changed_scene(Scene scene, RandomPolygons& random, const Lattice& lattice);

/// The scene with the names and colours that its polygons should have.
AdmittedScene lettered(Scene scene);

}  // namespace vidno
