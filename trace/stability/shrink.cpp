#include "stability/shrink.h"

#include <algorithm>
#include <cmath>

#include "scene/exact_scene.h"

namespace vidno {

namespace {

/// A sublist that `holds` and cannot lose any single element. It tries to remove ever smaller parts, halves first.
template <class T>
std::vector<T> least_sublist(std::vector<T> list, const auto& holds) {
    for (std::size_t part = (list.size() + 1) / 2; part > 0;) {
        bool smaller = false;
        for (std::size_t first = 0; first < list.size();) {
            std::vector<T> rest = list;
            const auto begin = rest.begin() + std::ptrdiff_t(first);
            rest.erase(begin, begin + std::ptrdiff_t(std::min(part, list.size() - first)));
            if (holds(rest)) {
                list = std::move(rest);
                smaller = true;
            } else {
                first += part;
            }
        }
        if (part > 1 || !smaller) part /= 2;
    }
    return list;
}

/// The scene with another outline for a polygon, if that is admitted.
std::optional<Scene> with_vertices(Scene scene, std::size_t polygon, std::vector<glm::dvec3> vertices) {
    auto& changed = scene.polygons[polygon];
    changed.vertices = std::move(vertices);
    if (exact_scene::admit(changed).admission != Admission::admitted) return std::nullopt;
    return scene;
}

Scene with_fewest_polygons(Scene scene, const Property& keeps) {
    const auto with = [&](const std::vector<ScenePolygon>& polygons) {
        Scene candidate = scene;
        candidate.polygons = polygons;
        return candidate;
    };
    return with(least_sublist(scene.polygons, [&](const auto& polygons) { return keeps(with(polygons)); }));
}

Scene with_fewest_vertices(Scene scene, const Property& keeps) {
    for (std::size_t polygon = 0; polygon < scene.polygons.size(); ++polygon) {
        const auto holds = [&](const auto& vertices) {
            const auto candidate = with_vertices(scene, polygon, vertices);
            return candidate && keeps(*candidate);
        };
        scene = *with_vertices(scene, polygon, least_sublist(scene.polygons[polygon].vertices, holds));
    }
    return scene;
}

/// The scene with one coordinate rounded to as few places as possible, or unchanged.
Scene with_shorter_coordinate(Scene scene, std::size_t polygon, std::size_t vertex, int axis, const Property& keeps) {
    const auto& vertices = scene.polygons[polygon].vertices;
    const double value = vertices[vertex][axis];
    const int most = binary_places(value);
    for (int places = 0; places < most; ++places) {
        auto rounded = vertices;
        rounded[vertex][axis] = snapped(value, places);
        const auto candidate = with_vertices(scene, polygon, std::move(rounded));
        // Admission may drop a vertex, but another step changes their number.
        if (!candidate || candidate->polygons[polygon].vertices.size() != vertices.size()) continue;
        if (keeps(*candidate)) return *candidate;
    }
    return scene;
}

/// The scene with as few binary places as possible, reduced one coordinate at a time.
Scene with_fewest_places(Scene scene, const Property& keeps) {
    for (std::size_t polygon = 0; polygon < scene.polygons.size(); ++polygon) {
        for (std::size_t vertex = 0; vertex < scene.polygons[polygon].vertices.size(); ++vertex) {
            for (int axis = 0; axis < 3; ++axis) {
                scene = with_shorter_coordinate(std::move(scene), polygon, vertex, axis, keeps);
            }
        }
    }
    return scene;
}

}  // namespace

std::size_t vertices_of(const Scene& scene) {
    std::size_t count = 0;
    for (const auto& polygon : scene.polygons) count += polygon.vertices.size();
    return count;
}

int binary_places(double value) {
    int places = 0;
    while (snapped(value, places) != value) ++places;
    return places;
}

Scene without_polygon(Scene scene, std::size_t index) {
    scene.polygons.erase(scene.polygons.begin() + std::ptrdiff_t(index));
    return scene;
}

std::optional<Scene> without_vertex(Scene scene, std::size_t polygon, std::size_t vertex) {
    auto vertices = scene.polygons[polygon].vertices;
    vertices.erase(vertices.begin() + std::ptrdiff_t(vertex));
    return with_vertices(std::move(scene), polygon, std::move(vertices));
}

Scene with_fewest_parts(Scene scene, const Property& keeps) {
    for (;;) {
        Scene fewer = with_fewest_vertices(with_fewest_polygons(scene, keeps), keeps);
        if (fewer == scene) return scene;
        scene = std::move(fewer);
    }
}

Scene shrunk(Scene scene, const Property& keeps) {
    for (;;) {
        Scene smaller = with_fewest_places(with_fewest_parts(scene, keeps), keeps);
        if (smaller == scene) return scene;
        scene = std::move(smaller);
    }
}

CurveScene shrunk(CurveScene scene, const std::function<bool(const CurveScene&)>& keeps) {
    const auto with_curves = [&](const std::vector<Curve>& curves) { return CurveScene{scene.area, curves}; };
    const auto with_samples = [&](std::size_t curve, const std::vector<Sample>& samples) {
        CurveScene candidate = scene;
        candidate.curves[curve].samples = samples;
        return candidate;
    };
    for (;;) {
        const CurveScene before = scene;
        scene =
            with_curves(least_sublist(scene.curves, [&](const auto& curves) { return keeps(with_curves(curves)); }));
        for (std::size_t curve = 0; curve < scene.curves.size(); ++curve) {
            scene = with_samples(curve, least_sublist(scene.curves[curve].samples, [&](const auto& samples) {
                                     return samples.size() >= 2 && keeps(with_samples(curve, samples));
                                 }));
            for (std::size_t i = 0; i < scene.curves[curve].samples.size(); ++i) {
                const double value = scene.curves[curve].samples[i].y;
                const int most = binary_places(value);
                for (int places = 0; places < most; ++places) {
                    auto samples = scene.curves[curve].samples;
                    samples[i].y = snapped(value, places);
                    const CurveScene candidate = with_samples(curve, samples);
                    if (!keeps(candidate)) continue;
                    scene = candidate;
                    break;
                }
            }
        }
        if (scene == before) return scene;
    }
}

}  // namespace vidno
