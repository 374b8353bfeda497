#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>

#include "vidno/admission.h"

namespace vidno::test {

SceneBuilder::SceneBuilder(Area area) { scene_.area = area; }

SceneBuilder& SceneBuilder::polygon(Corners vertices) {
    const std::size_t index = scene_.polygons.size();
    return polygon(std::string(1, char('A' + index % 26)) + (index < 26 ? "" : std::to_string(index / 26)),
                   color_of(index), std::move(vertices));
}
SceneBuilder& SceneBuilder::polygon(std::string id, Color color, Corners vertices) {
    scene_.polygons.push_back({std::move(id), color, std::move(vertices), false});
    return *this;
}
SceneBuilder& SceneBuilder::quad(double left, double top, double right, double bottom, double z) {
    return polygon({{left, top, z}, {right, top, z}, {right, bottom, z}, {left, bottom, z}});
}

AdmittedScene SceneBuilder::build() const { return admit(scene_); }

AdmittedScene small_scene() {
    return SceneBuilder({-3, 2, 9, 7})
        .polygon({{-4, 1, 0}, {7, 3, .5}, {0, 10, 1}})
        .quad(-2, 3, 4, 8, .25)
        .polygon({{0, 2.5, .75}, {5, 2.5, .75}, {2.5, 8.5, -1}})
        .build();
}

RandomScenes::RandomScenes(unsigned seed) : RandomPolygons(std::mt19937(seed)) {}

Area RandomScenes::area() {
    static constexpr int sides[]{1, 3, 7, 8, 10, 13, 16};
    return {whole(-20, 20), whole(-20, 20), sides[whole(0, 6)], sides[whole(0, 6)]};
}

AdmittedScene RandomScenes::scene() {
    const Area drawing = area();
    SceneBuilder builder(drawing);
    for (int i = whole(1, 5); i > 0; --i) {
        switch (whole(0, 3)) {
            case 0: builder.polygon(triangle(drawing)); break;
            case 1: builder.polygon(box(drawing)); break;
            case 2: builder.polygon(sliver(drawing)); break;
            default: const auto [a, b] = neighbours(drawing); builder.polygon(a).polygon(b);
        }
    }
    return builder.build();
}

std::optional<AdmittedScene> moved_by_ulps(Scene scene, RandomScenes& random) {
    for (auto& polygon : scene.polygons) {
        for (auto& vertex : polygon.vertices) {
            for (int axis = 0; axis < 3; ++axis) {
                const int ulps = random.whole(-2, 2);
                for (int i = 0; i < std::abs(ulps); ++i) vertex[axis] = std::nextafter(vertex[axis], ulps * 1e9);
            }
            vertex.z = std::clamp(vertex.z, -1., 1.);
        }
        if (admit_polygon(polygon).admission != Admission::admitted) return std::nullopt;
    }
    return admit(std::move(scene));
}

}  // namespace vidno::test
