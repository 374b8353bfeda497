/// The library's exact decisions on scenes, compiled once, so that code that reads or changes scenes does not compile CGAL.
///
/// vidno/admission.h, look.h and snap.h describe these functions.
#pragma once

#include <vector>

#include "vidno/admitted.h"
#include "vidno/camera.h"
#include "vidno/resolution.h"

namespace vidno::exact_scene {

AdmittedScene admit(Scene scene);
PolygonAdmission admit_polygon(ScenePolygon& polygon);
PolygonAdmission admit_in_world(ScenePolygon& polygon);
std::vector<ScenePolygon> cut_into_triangles(const ScenePolygon& polygon);
Seen look(const View& view, const ScenePolygon& world);
AdmittedScene snapped(const AdmittedScene& scene, Resolution to);
std::vector<ScenePolygon> snapped(const ScenePolygon& polygon, Resolution to, Snapping& snapping);

/// Whether `count` numbers start, start + step, start + 2 step and so on are doubles without rounding.
bool are_doubles(double start, double step, int count);

}  // namespace vidno::exact_scene
