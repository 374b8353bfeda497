/// What the library decides exactly of a scene, compiled once: who reads or changes scenes compiles no CGAL.
///
/// The functions are those of vidno/admission.h, look.h and snap.h, where they are described.
#pragma once

#include <vector>

#include "vidno/admitted.h"
#include "vidno/camera.h"
#include "vidno/resolution.h"

namespace vidno::exact_scene {

Admitted admit(ScenePolygon& polygon);
Admitted admit_in_world(ScenePolygon& polygon);
std::vector<ScenePolygon> cut_into_triangles(const ScenePolygon& polygon);
Seen look(const View& view, const ScenePolygon& world);
Scene snapped(Scene scene, Resolution to);
std::vector<ScenePolygon> snapped(const ScenePolygon& polygon, Resolution to, Snapping& snapping);

/// Whether start, start + step, start + 2 step and so on are doubles without rounding, this many of them.
bool are_doubles(double start, double step, int count);

}  // namespace vidno::exact_scene
