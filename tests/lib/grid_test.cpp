// The kernel `grid`: the effect of snapping, and that a snapped scene is painted right.

#include <doctest/doctest.h>

#include "refused.h"
#include "scene/snapped_scene.h"
#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"

using namespace vidno;
using namespace vidno::test;

namespace {

void check_picture_rule(const AdmittedScene& scene, int bits) {
    const Picture expected = Reference(scene).picture();
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        CHECK(different_pixels(render(method, scene, Grid(bits)), expected) == 0);
    }
}

}  // namespace

TEST_CASE("Snapping: to the nearest point of the grid, a tie away from 0") {
    CHECK(snapped(0.3, 2) == 0.25);
    CHECK(snapped(0.4, 2) == 0.5);
    CHECK(snapped(0.125, 2) == 0.25);
    CHECK(snapped(-0.125, 2) == -0.25);
    CHECK(snapped(7, 2) == 7);
}

TEST_CASE("Snapping: a polygon on the grid stays whole, another one becomes a fan") {
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8})
                                    .quad(1, 1, 6.5, 6, .5)
                                    .polygon({{1, 1, 0}, {7, 1.125, 0}, {7, 7, 0}, {1, 7, 0}})
                                    .build();
    const auto [halves, sources, to_halves] = snapped_scene(scene, 1);
    CHECK(sources == std::vector<std::size_t>{0, 1, 1});
    REQUIRE(halves->polygons.size() == 3);
    CHECK(halves->polygons[0] == scene->polygons[0]);
    CHECK(halves->polygons[1].id == "B.1");
    CHECK(halves->polygons[1].vertices == Corners{{1, 1, 0}, {7, 1, 0}, {7, 7, 0}});
    CHECK(halves->polygons[2].id == "B.2");
    CHECK(halves->polygons[2].vertices == Corners{{1, 1, 0}, {7, 7, 0}, {1, 7, 0}});
    CHECK(to_halves.cut == 1);
    CHECK(to_halves.moved == 1);
    CHECK(to_halves.vertices == 4 + 3 + 3);
    CHECK(to_halves.farthest_moved == .125);
    CHECK(to_halves.deepest_moved == 0);
    CHECK(snapped_scene(scene, 3).change().empty());
}

TEST_CASE("Snapping: the changes in words") {
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8})
                                    .polygon({{1, 1, 0x1p-25}, {7, 1, 0}, {4, 1.0625, 0}})
                                    .quad(1, 1, 6.75, 6, .5)
                                    .build();
    CHECK(snapped_scene(scene, 1).change() ==
          "cut 1 polygon into triangles; moved 5 of 9 vertices by at most 0.25 pixels and 2.98023e-08 in z; left 1 "
          "triangle "
          "without area");
}

TEST_CASE("Snapping twice is snapping once") {
    RandomScenes random(3);
    for (int i = 0; i < 100; ++i) {
        const SnappedScene once = snapped_scene(random.scene(), 2);
        const SnappedScene twice = snapped_scene(once.scene, 2);
        CHECK(twice.scene == once.scene);
        CHECK(twice.change().empty());
    }
}

TEST_CASE("Snapped scenes, random and degenerate, on coarse grids and fine: no wrong pixel, and some under double") {
    RandomScenes random(99);
    int wrong_in_double = 0;
    for (int i = 0; i < 2000; ++i) {
        const int bits = random.whole(1, 12);
        CAPTURE(i);
        CAPTURE(bits);
        const AdmittedScene scene = snapped_scene(random.scene(), bits).scene;
        check_picture_rule(scene, bits);
        wrong_in_double += different_pixels(render(Method::warnock, scene, Double{}), Reference(scene).picture());
    }
    CHECK(wrong_in_double > 0);
}

TEST_CASE("The segment between two edges that meet a side of a window is part of the side") {
    // Because of the second triangle, windows are split down to 2 x 2 pixels. The one at (2, 2) clips the first
    // triangle alone. The edge y = x meets its right side at (4, 4), and the edge from (5, 5) to (1, -7) at (4, 2). So
    // in row 2 the first triangle covers the centres 2.5 and 3.5.
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8})
                                    .polygon({{1, -7, 0.125}, {-7, -7, 0.125}, {5, 5, 0.125}})
                                    .polygon({{1, 1, -0.5}, {5, 1, -0.5}, {-5.5, 0, -0.5}})
                                    .build();
    for (const int bits : {1, 4}) {
        const Picture picture = render(Method::warnock, scene, Grid(bits));
        CHECK(picture.at(2, 2) == scene->polygons[0].color);
        CHECK(picture.at(3, 2) == scene->polygons[0].color);
        check_picture_rule(scene, bits);
    }
}

TEST_CASE("Vertices on whole numbers: edges often meet the corners of windows, and no pixel is wrong") {
    RandomScenes random(2711);
    for (int i = 0; i < 4000; ++i) {
        SceneBuilder builder({0, 0, 8, 8});
        for (int polygon = 0; polygon < 4; ++polygon) {
            Corners corners(3);
            for (auto& corner : corners) {
                corner.x = random.whole(-4, 12);
                corner.y = random.whole(-4, 12);
            }
            const glm::dvec3 p = corners[1] - corners[0], q = corners[2] - corners[0];
            for (auto& corner : corners) corner.z = polygon / 8.0;
            if (p.x * q.y != p.y * q.x) builder.polygon(corners);
        }
        CAPTURE(i);
        check_picture_rule(builder.build(), 1);
    }
}

TEST_CASE("At the greatest width, ties and slivers are still decided right") {
    // On a grid of 1/2^20 an area of 8 is 2^23 steps across. The planes differ by one step of z, and the sliver's
    // sides, one step apart, pass through centres.
    const double step = 0x1p-20;
    const double deep = 0x1p-24;
    const AdmittedScene scene = SceneBuilder({0, 0, 8, 8})
                                    .polygon({{0, 0, -1}, {8, 0, 1}, {8, 8, 1 - deep}})
                                    .polygon({{0, 0, -1}, {8, 0, 1}, {8, 8, 1}})
                                    .polygon({{.5, 0, 1}, {.5 + step, 8, 1}, {.5 - step, 8, 1}})
                                    .polygon({{0, 8, 1 - deep}, {8, step, 1}, {8, 2 * step, 1 - 2 * deep}})
                                    .build();
    REQUIRE(snapped_scene(scene, 20).change().empty());
    check_picture_rule(scene, 20);
}

TEST_CASE("An area far from the origin") {
    const double x = 1 << 30, y = -(1 << 30);
    const AdmittedScene scene = SceneBuilder({1 << 30, -(1 << 30), 7, 9})
                                    .polygon({{x - 1, y, -.5}, {x + 6.25, y + 3.5, .5}, {x + 2.5, y + 8.5, 0}})
                                    .quad(x + 1, y + 1, x + 5.5, y + 5.5, 0)
                                    .build();
    check_picture_rule(snapped_scene(scene, 8).scene, 8);
}

TEST_CASE("A grid too fine for the scene's width is refused, and the finest that fits is named") {
    // 2^24 steps of 1/2^15 are 512 pixels: one too many.
    const AdmittedScene scene = SceneBuilder({0, 0, 512, 512}).polygon({{0, 0, 0}, {512, 0, 0}, {0, 512, 0}}).build();
    CHECK(fits_grid(scene, 14));
    CHECK_THROWS_WITH_AS(snapped_scene(scene, 15),
                         "the scene is too wide for a grid of 1/2^15 pixel; grid:14 is the finest that fits", Refused);
    const AdmittedScene wide = SceneBuilder({0, 0, 8, 8}).polygon({{0, 0, 0}, {0x1p40, 0, 0}, {0, 8, 0}}).build();
    CHECK_THROWS_WITH_AS(snapped_scene(wide, 1), "the scene is too wide for a grid of 1/2^1 pixel; none fits", Refused);
}

TEST_CASE("The coarser the grid, the farther the picture from that of the scene itself") {
    RandomScenes random(4);
    std::array<int, 3> wrong{};
    for (int i = 0; i < 200; ++i) {
        const AdmittedScene scene = random.scene();
        const Picture expected = Reference(scene).picture();
        for (std::size_t knob = 0; knob < wrong.size(); ++knob) {
            const int bits = std::array{1, 3, 8}[knob];
            wrong[knob] +=
                different_pixels(render(Method::zbuffer, snapped_scene(scene, bits).scene, Grid(bits)), expected);
        }
    }
    CHECK(wrong[0] > wrong[1]);
    CHECK(wrong[1] > wrong[2]);
}
