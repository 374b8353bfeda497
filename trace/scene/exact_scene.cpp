#include "scene/exact_scene.h"

#include "choice/method.h"
#include "vidno/family/closed_bodies.h"
#include "vidno/kernels/exact.h"
#include "vidno/look.h"
#include "vidno/snap.h"

namespace vidno {

namespace exact_scene {

AdmittedScene admit(Scene scene) { return vidno::admit(std::move(scene)); }
PolygonAdmission admit_polygon(ScenePolygon& polygon) { return vidno::admit_polygon(polygon); }
PolygonAdmission admit_in_world(ScenePolygon& polygon) { return vidno::admit_in_world(polygon); }
std::vector<ScenePolygon> cut_into_triangles(const ScenePolygon& polygon) { return vidno::cut_into_triangles(polygon); }
Seen look(const View& view, const ScenePolygon& world) { return vidno::look(view, world); }
AdmittedScene snapped(const AdmittedScene& scene, Resolution to) { return vidno::snapped(scene, to); }
std::vector<ScenePolygon> snapped(const ScenePolygon& polygon, Resolution to, Snapping& snapping) {
    return vidno::snapped(polygon, to, snapping);
}

bool are_doubles(double start, double step, int count) {
    for (int i = 0; i < count; ++i) {
        const double place = start + i * step;
        if (!std::isfinite(place) || Rational(place) != Rational(start) + i * Rational(step)) return false;
    }
    return true;
}

}  // namespace exact_scene

std::optional<std::string> refuses_bodies(const Scene& scene) { return not_closed_convex_bodies(scene); }

}  // namespace vidno
