/// The library's exact decisions on scenes, compiled once, so that code that reads or changes scenes does not compile
/// CGAL.
///
/// vidno/admission.h, look.h and snap.h describe these functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vidno/admitted.h"
#include "vidno/camera.h"
#include "vidno/resolution.h"

namespace vidno::exact_scene {

AdmittedScene admit(Scene scene);
PolygonAdmission admit_polygon(ScenePolygon& polygon);
PolygonAdmission admit_in_world(ScenePolygon& polygon);
std::vector<ScenePolygon> cut_into_triangles(const ScenePolygon& polygon);

/// The admitted parts of a planar polygon that is not convex, all with its id; none if its outline touches or crosses
/// itself.
std::vector<ScenePolygon> cut_into_convex_parts(const ScenePolygon& polygon);
/// Its convex parts in the world.
std::vector<ScenePolygon> cut_into_convex_parts_in_world(const ScenePolygon& polygon);

/// What to say of a polygon whose shape is refused: the vertex at fault, if it is one, and the reason.
struct ShapeFault {
    std::optional<std::size_t> vertex;
    std::string reason;
};
ShapeFault fault_of_shape(const ScenePolygon& polygon, Admission admission, bool in_world);
Seen look(const View& view, const ScenePolygon& world);
AdmittedScene snapped(const AdmittedScene& scene, Resolution to);
std::vector<ScenePolygon> snapped(const ScenePolygon& polygon, Resolution to, Snapping& snapping);

/// Whether `count` numbers start, start + step, start + 2 step and so on are doubles without rounding.
bool are_doubles(double start, double step, int count);

}  // namespace vidno::exact_scene
