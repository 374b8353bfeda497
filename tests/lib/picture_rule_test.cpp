// The picture rule: both corrected methods under `exact` and `filtered` paint the same pixels as the brute-force
// rational reference, on random and on degenerate scenes.

#include <doctest/doctest.h>

#include "support/reference.h"
#include "support/scenes.h"
#include "support/stage.h"

using namespace vidno;
using namespace vidno::test;

namespace {

void check_picture_rule(const AdmittedScene& scene) {
    const Picture expected = Reference(scene).picture();
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        CHECK(different_pixels(render(method, scene, Exact{}), expected) == 0);
        CHECK(different_pixels(render(method, scene, Filtered{}), expected) == 0);
    }
}

}  // namespace

TEST_CASE("Random and degenerate scenes") {
    RandomScenes random(20261121);
    for (int i = 0; i < 2000; ++i) {
        CAPTURE(i);
        check_picture_rule(random.scene());
    }
}

TEST_CASE("Vertices on pixel centres") {
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{2.5, 2.5, 0}, {12.5, 4.5, .25}, {6.5, 11.5, .5}})
                           .polygon({{.5, .5, .25}, {15.5, .5, .25}, {.5, 15.5, .25}})
                           .build());
}

TEST_CASE("Coplanar overlaps: the first wins") {
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{0, 0, 0}, {10, 0, .625}, {10, 10, .625}, {0, 10, 0}})
                           .polygon({{4, 4, .25}, {16, 4, 1}, {16, 16, 1}, {4, 16, .25}})
                           .build());
}

TEST_CASE("A fan of triangles that share edges and a vertex covers without gaps") {
    const glm::dvec3 hub(7.5, 7.5, .5);
    const Corners rim{{0, 0, 0},   {7.5, -1, 0}, {16, 0, 0}, {17, 7.5, 0},
                      {16, 16, 0}, {7.5, 17, 0}, {0, 16, 0}, {-1, 7.5, 0}};
    SceneBuilder builder(area_16);
    for (std::size_t i = 0; i < rim.size(); ++i) builder.polygon({hub, rim[i], rim[(i + 1) % rim.size()]});
    const AdmittedScene scene = builder.build();
    check_picture_rule(scene);
    const Picture picture = render(Method::zbuffer, scene, Exact{});
    CHECK(std::count(picture.pixels().begin(), picture.pixels().end(), white) == 0);
}

TEST_CASE("Edge-on polygons and slivers") {
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{0, 0, 1}, {16, 16, 1}, {8, 8, -1}})
                           .polygon({{.5, 0, 0}, {.5, 16, 0}, {.5, 8, .5}})
                           .polygon({{0, 8, 0}, {16, 8.5, 0}, {16, 8.53125, 0}})
                           .polygon({{3.5, 0, 0}, {3.5 + 0x1p-40, 8, 0}, {3.5, 16, 0}})
                           .build());
}

TEST_CASE("Interpenetrating polygons") {
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{0, 2, 0}, {16, 2, 1}, {16, 14, 1}, {0, 14, 0}})
                           .polygon({{2, 0, 1}, {14, 0, 1}, {14, 16, 0}, {2, 16, 0}})
                           .quad(1, 1, 15, 15, .5)
                           .build());
}

TEST_CASE("Cyclic overlap") {
    // Each bar is in front of the next at one end and behind the one before at the other.
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{1, 2, .75}, {15, 2, .25}, {15, 5, .25}, {1, 5, .75}})
                           .polygon({{11, 1, .75}, {14, 1, .75}, {14, 15, .25}, {11, 15, .25}})
                           .polygon({{1, 11, .25}, {15, 11, .75}, {15, 14, .75}, {1, 14, .25}})
                           .polygon({{2, 1, .25}, {5, 1, .25}, {5, 15, .75}, {2, 15, .75}})
                           .build());
}

TEST_CASE("Areas of any size and place") {
    for (const Area area :
         {Area{0, 0, 1, 1}, {3, 5, 7, 1}, {-100, 40, 1, 9}, {-8, -8, 13, 11}, {1 << 30, -(1 << 30), 5, 6}}) {
        CAPTURE(area.x);
        const double x = area.x, y = area.y;
        check_picture_rule(SceneBuilder(area)
                               .quad(x - 1, y - 1, x + 4.5, y + 3, .25)
                               .polygon({{x, y, -1}, {x + 12, y + 2, 1}, {x + 3, y + 10, 0}})
                               .build());
    }
}

TEST_CASE("Depths of exactly -1 and 1") {
    check_picture_rule(SceneBuilder(area_16)
                           .quad(0, 0, 16, 16, -1)
                           .quad(4, 4, 12, 12, 1)
                           .polygon({{0, 0, -1}, {16, 0, 1}, {16, 16, 1}, {0, 16, -1}})
                           .build());
}

TEST_CASE("A quad that is planar only within the tolerance") {
    // The last vertex is off the plane of the others by 2^-42 of the extent 16: 2^-38.
    check_picture_rule(SceneBuilder(area_16)
                           .polygon({{1, 1, .25}, {15, 1, .5}, {15, 15, .5}, {1, 15, .25 + 0x1p-38}})
                           .quad(4, 4, 12, 12, .375)
                           .build());
}

TEST_CASE("Where rounding decides nothing, `float` and `double` paint the picture rule too") {
    const AdmittedScene scene = SceneBuilder(area_16)
                                    .quad(2, 2, 10, 10, .25)
                                    .quad(6, 6, 14, 14, .5)
                                    .polygon({{0, 0, 0}, {16, 0, 0}, {0, 16, 0}})
                                    .build();
    const Picture expected = Reference(scene).picture();
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        CHECK(render(method, scene, Double{}) == expected);
        CHECK(render(method, scene, Float{}) == expected);
    }
}
