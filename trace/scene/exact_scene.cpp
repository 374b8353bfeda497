#include "scene/exact_scene.h"

#include "choice/method.h"
#include "json/json_text.h"
#include "scene/convex_parts.h"
#include "vidno/family/closed_bodies.h"
#include "vidno/kernels/exact.h"
#include "vidno/look.h"
#include "vidno/snap.h"

namespace vidno {

namespace exact_scene {

namespace {

/// The parts of a polygon that is not convex; `seen` has its vertices as seen from where it has an area.
std::vector<ScenePolygon> cut_as_seen(const ScenePolygon& polygon, const std::vector<glm::dvec3>& seen) {
    std::vector<ScenePolygon> parts;
    for (const Outline& outline : convex_parts(seen)) {
        ScenePolygon part{polygon.id, polygon.color, {}, false, face_of_parts(polygon)};
        ScenePolygon flat;
        for (const std::size_t i : outline) {
            part.vertices.push_back(polygon.vertices[i]);
            flat.vertices.push_back(seen[i]);
        }
        if (admit_shape(flat).admission == Admission::admitted) {
            parts.push_back(std::move(part));
        } else {
            // The tolerance is a share of the extent, which is smaller for a part.
            for (ScenePolygon& triangle : vidno::cut_into_triangles(part)) parts.push_back(std::move(triangle));
        }
    }
    if (parts.size() == 1) parts.front().face = polygon.face;
    return parts;
}

/// Three vertices that are not collinear on the screen, without one of them all; none if there are no such three.
std::optional<Triangle> anchors(const std::vector<glm::dvec3>& vertices, std::size_t without) {
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (i != without) left.push_back(i);
    }
    for (std::size_t i = 1; i + 1 < left.size(); ++i) {
        for (std::size_t k = i + 1; k < left.size(); ++k) {
            if (admission::turn(vertices[left[0]], vertices[left[i]], vertices[left[k]]) != 0) {
                return Triangle{left[0], left[i], left[k]};
            }
        }
    }
    return std::nullopt;
}

/// z of the plane through three vertices at the place of another.
double depth_in_plane(const std::vector<glm::dvec3>& vertices, const Triangle& plane, std::size_t vertex) {
    using admission::Exact, admission::difference;
    const auto& [i, j, k] = plane;
    const auto normal = admission::normal_of<Exact>({vertices[i], vertices[j], vertices[k]});
    const auto way = difference<Exact>(vertices[vertex], vertices[i]);
    return nearest_double(Exact(vertices[i].z) - (normal.x * way.x + normal.y * way.y) / normal.z);
}

/// The vertex without which a polygon is planar, the last such one; the last vertex if there is none.
std::size_t vertex_off_plane(const std::vector<glm::dvec3>& vertices) {
    for (std::size_t i = vertices.size(); i-- > 0;) {
        std::vector<glm::dvec3> others = vertices;
        others.erase(others.begin() + std::ptrdiff_t(i));
        if (admission::is_planar(others) && anchors(vertices, i)) return i;
    }
    return vertices.size() - 1;
}

/// As a scene file has it.
std::string text_of(const glm::dvec3& vertex) {
    Text text;
    for (int axis = 0; axis < 3; ++axis) {
        text += axis == 0 ? '[' : ',';
        append_number(text, vertex[axis]);
    }
    text += ']';
    return text.string();
}

ShapeFault fault_of_plane(const ScenePolygon& polygon, const std::vector<glm::dvec3>& seen, char coordinate) {
    const std::size_t vertex = vertex_off_plane(seen);
    const auto plane = anchors(seen, vertex);
    if (!plane) return {vertex, std::string(reason_of(Admission::not_planar))};
    const auto at = [&](std::size_t i) { return text_of(polygon.vertices[i]); };
    const auto& [i, j, k] = *plane;
    Text would_do;
    append_number(would_do, depth_in_plane(seen, *plane, vertex));
    return {vertex, "not planar: in the plane of " + at(i) + ", " + at(j) + " and " + at(k) +
                        " this vertex would have " + coordinate + " = " + would_do.string() +
                        "; triangles are always planar"};
}

ShapeFault fault_of_outline(const ScenePolygon& polygon, const std::vector<glm::dvec3>& seen) {
    if (seen.size() > most_corners_to_clip) {
        return {{},
                "not convex, and with more than " + std::to_string(most_corners_to_clip) + " vertices it is not cut"};
    }
    const auto crossing = crossing_edges(seen);
    if (!crossing) return {{}, "not convex, and the outline touches itself; cut the polygon there"};
    return {crossing->second, "not convex, and the edges from " + text_of(polygon.vertices[crossing->first]) + " and " +
                                  text_of(polygon.vertices[crossing->second]) + " cross; cut the polygon there"};
}

}  // namespace

AdmittedScene admit(Scene scene) { return vidno::admit(std::move(scene)); }
PolygonAdmission admit_polygon(ScenePolygon& polygon) { return vidno::admit_polygon(polygon); }
PolygonAdmission admit_in_world(ScenePolygon& polygon) { return vidno::admit_in_world(polygon); }
std::vector<ScenePolygon> cut_into_triangles(const ScenePolygon& polygon) { return vidno::cut_into_triangles(polygon); }
std::vector<ScenePolygon> cut_into_convex_parts(const ScenePolygon& polygon) {
    return cut_as_seen(polygon, polygon.vertices);
}
std::vector<ScenePolygon> cut_into_convex_parts_in_world(const ScenePolygon& polygon) {
    return cut_as_seen(polygon, seen_along(axis_that_shows(polygon.vertices), polygon.vertices));
}

ShapeFault fault_of_shape(const ScenePolygon& polygon, Admission admission, bool in_world) {
    if (admission != Admission::not_planar && admission != Admission::not_convex) {
        return {{}, std::string(reason_of(admission))};
    }
    const int axis = in_world ? axis_that_shows(polygon.vertices) : 2;
    const auto seen = seen_along(axis, polygon.vertices);
    return admission == Admission::not_planar ? fault_of_plane(polygon, seen, "xyz"[axis])
                                              : fault_of_outline(polygon, seen);
}

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
