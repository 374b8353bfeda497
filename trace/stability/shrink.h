/// Shrink: the smallest scene that still has a property.
///
/// Source  A. Zeller and R. Hildebrandt, Simplifying and isolating failure-inducing input, IEEE Transactions on
///         Software Engineering 28(2), 2002.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "vidno/floating_horizon/curves.h"
#include "vidno/scene.h"

namespace vidno {

/// A property of a scene. It is called often.
using Property = std::function<bool(const AdmittedScene&)>;

/// Takes   a scene with the property.
/// Gives   a scene that has it too, but loses it if any polygon or any vertex is left out, or any coordinate is rounded
///         to fewer binary places.
AdmittedScene shrunk(AdmittedScene scene, const Property& keeps);

/// Smaller curves: the result cannot lose a curve, a sample or a binary place of a height.
AdmittedCurves shrunk(AdmittedCurves scene, const std::function<bool(const AdmittedCurves&)>& keeps);

/// A scene with fewer polygons and vertices only; coordinates do not change.
AdmittedScene with_fewest_parts(AdmittedScene scene, const Property& keeps);

/// The scene without one of its polygons.
AdmittedScene without_polygon(Scene scene, std::size_t index);

/// The scene without a vertex, if the rest of the polygon is admitted.
std::optional<AdmittedScene> without_vertex(Scene scene, std::size_t polygon, std::size_t vertex);

/// The total number of vertices.
std::size_t vertices_of(const Scene& scene);

/// The least k >= 0 such that the value is a multiple of 2^-k.
int binary_places(double value);

}  // namespace vidno
