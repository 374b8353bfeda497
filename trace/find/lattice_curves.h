/// Random curves with small numbers, and random changes of curves, for a search.
#pragma once

#include <optional>

#include "find/lattice_scenes.h"

namespace vidno {

/// Curves over an area that begins at (0, 0): independent ones, or ones that meet or run along another; some with
/// gaps, some over a part of the columns; or now and then curves of the families.
std::optional<AdmittedCurves> lattice_curves(RandomPolygons& random, const Lattice& lattice);

/// The curves with one change, or a few: of the area, a curve or a sample. None if no curves remain.
std::optional<AdmittedCurves> changed_scene(CurveScene scene, RandomPolygons& random, const Lattice& lattice);

}  // namespace vidno
