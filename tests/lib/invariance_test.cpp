// Transformations that do not change the scene do not change the picture.

#include <doctest/doctest.h>

#include "support/scenes.h"
#include "support/stage.h"

using namespace vidno;
using namespace vidno::test;

namespace {

template <class Change>
Scene changed(Scene scene, Change change) {
    for (auto& polygon : scene.polygons) change(polygon.vertices);
    return scene;
}

void check_same_colors(const AdmittedScene& scene, Scene changed) {
    const AdmittedScene other = admit(std::move(changed));
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        const auto expected = render(method, scene, Exact{}).pixels();
        CHECK(render(method, other, Exact{}).pixels() == expected);
    }
}

template <class Check>
void on_random_scenes(unsigned seed, Check check) {
    RandomScenes random(seed);
    for (int i = 0; i < 60; ++i) {
        CAPTURE(i);
        check(random.scene());
    }
}

}  // namespace

TEST_CASE("Outlines that start at another vertex") {
    on_random_scenes(1, [](const AdmittedScene& scene) {
        check_same_colors(scene, changed(scene, [](auto& v) { std::rotate(v.begin(), v.begin() + 1, v.end()); }));
    });
}

TEST_CASE("Outlines in the opposite direction") {
    on_random_scenes(2, [](const AdmittedScene& scene) {
        check_same_colors(scene, changed(scene, [](auto& v) { std::reverse(v.begin(), v.end()); }));
    });
}

TEST_CASE("Polygons in another order, where no two depths tie") {
    RandomScenes random(3);
    for (int i = 0; i < 60; ++i) {
        CAPTURE(i);
        // Each polygon is at its own depth, so there are no ties.
        SceneBuilder builder(random.area());
        const auto area = builder.build()->area;
        for (int level = 0; level < 5; ++level) {
            auto triangle = random.triangle(area);
            for (auto& vertex : triangle) vertex.z = level / 8.0;
            builder.polygon(triangle);
        }
        const AdmittedScene scene = builder.build();
        Scene reversed = scene;
        std::reverse(reversed.polygons.begin(), reversed.polygons.end());
        check_same_colors(scene, reversed);
    }
}

TEST_CASE("The scene shifted by whole pixels") {
    on_random_scenes(4, [](const AdmittedScene& scene) {
        Scene shifted = changed(scene, [](auto& v) {
            for (auto& vertex : v) vertex += glm::dvec3(1000, -37, 0);
        });
        shifted.area.x += 1000;
        shifted.area.y -= 37;
        check_same_colors(scene, shifted);
    });
}

TEST_CASE("The scene scaled by two: pixels doubled and sampled between their centres") {
    // A pixel centre of the scene, (i + 1/2, j + 1/2), becomes a corner of four pixels; shifted by half a pixel it is
    // the centre of the pixel (2i, 2j) of an area of twice the size.
    on_random_scenes(5, [](const AdmittedScene& scene) {
        Scene scaled = changed(scene, [](auto& v) {
            for (auto& vertex : v) vertex = {2 * vertex.x - .5, 2 * vertex.y - .5, vertex.z};
        });
        scaled.area = {2 * scene->area.x, 2 * scene->area.y, 2 * scene->area.width, 2 * scene->area.height};
        for (const Method method : {Method::warnock, Method::zbuffer}) {
            const Picture small = render(method, scene, Exact{});
            const Picture large = render(method, admit(scaled), Exact{});
            int different = 0;
            for (int y = scene->area.y; y < scene->area.bottom(); ++y) {
                for (int x = scene->area.x; x < scene->area.right(); ++x) {
                    different += small.at(x, y) == large.at(2 * x, 2 * y) ? 0 : 1;
                }
            }
            CHECK(different == 0);
        }
    });
}
