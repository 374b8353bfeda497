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
std::optional<AdmittedScene> with_vertices(Scene scene, std::size_t polygon, std::vector<glm::dvec3> vertices) {
    auto& changed = scene.polygons[polygon];
    changed.vertices = std::move(vertices);
    if (exact_scene::admit_polygon(changed).admission != Admission::admitted) return std::nullopt;
    return exact_scene::admit(std::move(scene));
}

AdmittedScene with_fewest_polygons(const AdmittedScene& scene, const Property& keeps) {
    const auto with = [&](const std::vector<ScenePolygon>& polygons) {
        return exact_scene::admit({scene->name, scene->area, scene->background, polygons});
    };
    return with(least_sublist(scene->polygons, [&](const auto& polygons) { return keeps(with(polygons)); }));
}

AdmittedScene with_fewest_vertices(AdmittedScene scene, const Property& keeps) {
    for (std::size_t polygon = 0; polygon < scene->polygons.size(); ++polygon) {
        const auto holds = [&](const auto& vertices) {
            const auto candidate = with_vertices(scene, polygon, vertices);
            return candidate && keeps(*candidate);
        };
        scene = *with_vertices(scene, polygon, least_sublist(scene->polygons[polygon].vertices, holds));
    }
    return scene;
}

/// The scene with one coordinate rounded to as few places as possible, or unchanged.
AdmittedScene with_shorter_coordinate(AdmittedScene scene, std::size_t polygon, std::size_t vertex, int axis,
                                      const Property& keeps) {
    const auto& vertices = scene->polygons[polygon].vertices;
    const double value = vertices[vertex][axis];
    const int most = binary_places(value);
    for (int places = 0; places < most; ++places) {
        auto rounded = vertices;
        rounded[vertex][axis] = snapped(value, places);
        const auto candidate = with_vertices(scene, polygon, std::move(rounded));
        // Admission may drop a vertex, but another step changes their number.
        if (!candidate || (*candidate)->polygons[polygon].vertices.size() != vertices.size()) continue;
        if (keeps(*candidate)) return *candidate;
    }
    return scene;
}

/// The scene with as few binary places as possible, reduced one coordinate at a time.
AdmittedScene with_fewest_places(AdmittedScene scene, const Property& keeps) {
    for (std::size_t polygon = 0; polygon < scene->polygons.size(); ++polygon) {
        for (std::size_t vertex = 0; vertex < scene->polygons[polygon].vertices.size(); ++vertex) {
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

AdmittedScene without_polygon(Scene scene, std::size_t index) {
    scene.polygons.erase(scene.polygons.begin() + std::ptrdiff_t(index));
    return exact_scene::admit(std::move(scene));
}

std::optional<AdmittedScene> without_vertex(Scene scene, std::size_t polygon, std::size_t vertex) {
    auto vertices = scene.polygons[polygon].vertices;
    vertices.erase(vertices.begin() + std::ptrdiff_t(vertex));
    return with_vertices(std::move(scene), polygon, std::move(vertices));
}

AdmittedScene with_fewest_parts(AdmittedScene scene, const Property& keeps) {
    for (;;) {
        AdmittedScene fewer = with_fewest_vertices(with_fewest_polygons(scene, keeps), keeps);
        if (fewer == scene) return scene;
        scene = std::move(fewer);
    }
}

AdmittedScene shrunk(AdmittedScene scene, const Property& keeps) {
    for (;;) {
        AdmittedScene smaller = with_fewest_places(with_fewest_parts(scene, keeps), keeps);
        if (smaller == scene) return scene;
        scene = std::move(smaller);
    }
}

AdmittedCurves shrunk(AdmittedCurves scene, const std::function<bool(const AdmittedCurves&)>& keeps) {
    const auto with_curves = [&](const std::vector<Curve>& curves) { return admit(CurveScene{scene->area, curves}); };
    const auto with_samples = [&](std::size_t curve, const std::vector<Sample>& samples) {
        CurveScene candidate = scene;
        candidate.curves[curve].samples = samples;
        return admit(std::move(candidate));
    };
    for (;;) {
        const AdmittedCurves before = scene;
        scene =
            with_curves(least_sublist(scene->curves, [&](const auto& curves) { return keeps(with_curves(curves)); }));
        for (std::size_t curve = 0; curve < scene->curves.size(); ++curve) {
            scene = with_samples(curve, least_sublist(scene->curves[curve].samples, [&](const auto& samples) {
                                     return samples.size() >= 2 && keeps(with_samples(curve, samples));
                                 }));
            for (std::size_t i = 0; i < scene->curves[curve].samples.size(); ++i) {
                const Sample& sample = scene->curves[curve].samples[i];
                if (!sample.has_point()) continue;
                const double value = sample.y;
                const int most = binary_places(value);
                for (int places = 0; places < most; ++places) {
                    auto samples = scene->curves[curve].samples;
                    samples[i].y = snapped(value, places);
                    const AdmittedCurves candidate = with_samples(curve, samples);
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
