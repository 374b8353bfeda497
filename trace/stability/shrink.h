/// Shrink: the smallest scene that still has a property.
///
/// Source  A. Zeller and R. Hildebrandt, Simplifying and isolating failure-inducing input, IEEE Transactions on Software
///         Engineering 28(2), 2002.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "vidno/floating_horizon/curves.h"
#include "vidno/scene.h"

namespace vidno {

/// Of an admitted scene. It is asked often.
using Property = std::function<bool(const Scene&)>;

/// Takes   a scene that has the property.
/// Gives   one that has it too, and loses it if any polygon or any vertex is left out, or any coordinate rounded to fewer
///         binary places.
Scene shrunk(Scene scene, const Property& keeps);

/// The same of curves: no curve, no sample and no binary place of a height can be spared.
CurveScene shrunk(CurveScene scene, const std::function<bool(const CurveScene&)>& keeps);

/// The same with polygons and vertices alone, coordinates as they are.
Scene with_fewest_parts(Scene scene, const Property& keeps);

/// The scene without one of its polygons.
Scene without_polygon(Scene scene, std::size_t index);

/// The scene without a vertex, if what is left of the polygon is one.
std::optional<Scene> without_vertex(Scene scene, std::size_t polygon, std::size_t vertex);

/// How many vertices its polygons have together.
std::size_t vertices_of(const Scene& scene);

/// The least k >= 0 such that the value is a multiple of 2^-k.
int binary_places(double value);

}  // namespace vidno
