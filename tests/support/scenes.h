/// Scenes for tests: builders for small polygons, and random and degenerate ones from a seed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "scene/families.h"
#include "vidno/admission.h"
#include "vidno/scene.h"

namespace vidno::test {

inline constexpr Color red{255, 0, 0}, green{0, 128, 0}, blue{0, 0, 255}, white{255, 255, 255};

class SceneBuilder {
public:
    explicit SceneBuilder(Area area) { scene_.area = area; }

    SceneBuilder& polygon(Corners vertices) {
        const std::size_t index = scene_.polygons.size();
        return polygon(std::string(1, char('A' + index % 26)) + (index < 26 ? "" : std::to_string(index / 26)),
                       color_of(index), std::move(vertices));
    }
    SceneBuilder& polygon(std::string id, Color color, Corners vertices) {
        scene_.polygons.push_back({std::move(id), color, std::move(vertices), false});
        return *this;
    }
    SceneBuilder& quad(double left, double top, double right, double bottom, double z) {
        return polygon({{left, top, z}, {right, top, z}, {right, bottom, z}, {left, bottom, z}});
    }

    AdmittedScene build() const { return admit(scene_); }

private:
    Scene scene_;
};

/// The quad Q over the whole 16 x 16 area, and the square N in its middle in front of it.
inline const Corners far_quad{{-1, -1, .125}, {17, -1, .125}, {17, 17, .125}, {-1, 17, .125}};
inline const Corners near_square{{4, 4, .5}, {12, 4, .5}, {12, 12, .5}, {4, 12, .5}};
inline constexpr Area area_16{0, 0, 16, 16};

/// Three polygons that overlap, on the coarsest grid, so that every kernel takes them unchanged.
inline AdmittedScene small_scene() {
    return SceneBuilder({-3, 2, 9, 7})
        .polygon({{-4, 1, 0}, {7, 3, .5}, {0, 10, 1}})
        .quad(-2, 3, 4, 8, .25)
        .polygon({{0, 2.5, .75}, {5, 2.5, .75}, {2.5, 8.5, -1}})
        .build();
}

/// With sanitizers a run takes ten times as long. The longest tests then take only one in `thinning` of their scenes or steps, and tests
/// of long runs by code that other tests run too are skipped.
#ifdef VIDNO_SANITIZED
inline constexpr bool sanitized = true;
inline constexpr int thinning = 8;
#else
inline constexpr bool sanitized = false;
inline constexpr int thinning = 1;
#endif

/// All kinds of polygons in areas of all sizes.
struct RandomScenes : RandomPolygons {
    explicit RandomScenes(unsigned seed) : RandomPolygons(std::mt19937(seed)) {}

    Area area() {
        static constexpr int sides[]{1, 3, 7, 8, 10, 13, 16};
        return {whole(-20, 20), whole(-20, 20), sides[whole(0, 6)], sides[whole(0, 6)]};
    }

    AdmittedScene scene() {
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
};

/// Each coordinate moved by up to two ulps: what was a coincidence becomes nearly one. None if a polygon is no longer admitted.
inline std::optional<AdmittedScene> moved_by_ulps(Scene scene, RandomScenes& random) {
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
