// The picture rule against an independent judge: CGAL's envelope, the brute-force reference and both methods under
// `exact` and `filtered` give the same picture of every scene of triangles. The visible regions of Weiler and Atherton
// have exactly the areas of the envelope's faces.

#include "envelope.h"

#include <doctest/doctest.h>

#include <glm/common.hpp>

#include "support/reference.h"
#include "support/scenes.h"
#include "vidno/admission.h"
#include "vidno/kernels/exact.h"
#include "vidno/kernels/filtered_regions.h"
#include "vidno/vidno.h"
#include "vidno/weiler_atherton.h"

using namespace vidno;
using namespace vidno::test;

namespace {

/// The scene in the smallest area that holds all triangles, since the envelope is not cut to an area.
AdmittedScene whole(Scene scene) {
    glm::dvec3 low(scene.area.x, scene.area.y, 0), high(scene.area.right(), scene.area.bottom(), 0);
    for (const auto& polygon : scene.polygons) {
        for (const auto& vertex : polygon.vertices) {
            low = glm::min(low, glm::floor(vertex));
            high = glm::max(high, glm::ceil(vertex));
        }
    }
    scene.area = {int(low.x), int(low.y), int(high.x - low.x), int(high.y - low.y)};
    return admit(std::move(scene));
}

const Rational& exactly(const Rational& number) { return number; }
Rational exactly(const Constructed& number) { return number.exactly(); }

template <class K>
void check_areas(const AdmittedScene& scene, const std::map<int, Rational>& expected) {
    std::map<int, Rational> areas;
    for (const auto& [polygon, outlines] : visible_regions(scene, K{}).regions) {
        areas[polygon] += exactly(area_of(outlines));
    }
    CHECK(areas == expected);
}

void check_regions(const AdmittedScene& scene) {
    const Envelope envelope(scene);
    const Picture expected = envelope.picture();
    CHECK(different_pixels(visible_regions(scene, Exact{}).picture, expected) == 0);
    CHECK(different_pixels(visible_regions(scene, Filtered{}).picture, expected) == 0);
    check_areas<Exact>(whole(scene), envelope.areas());
    check_areas<Filtered>(whole(scene), envelope.areas());
}

void check_pictures(const AdmittedScene& scene) {
    const Picture expected = Envelope(scene).picture();
    CHECK(different_pixels(Reference(scene).picture(), expected) == 0);
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        CHECK(different_pixels(render(method, scene, Exact{}), expected) == 0);
        CHECK(different_pixels(render(method, scene, Filtered{}), expected) == 0);
    }
}

void check_all_agree(const AdmittedScene& scene) {
    check_pictures(scene);
    check_regions(scene);
}

/// Each polygon as a fan of triangles, each with its own colour.
AdmittedScene triangulated(const AdmittedScene& scene) {
    SceneBuilder builder(scene->area);
    for (const auto& polygon : scene->polygons) {
        const auto& v = polygon.vertices;
        for (std::size_t i = 2; i < v.size(); ++i) builder.polygon({v[0], v[i - 1], v[i]});
    }
    return builder.build();
}

}  // namespace

TEST_CASE("The envelope by hand: closed outlines, ties, an edge-on triangle") {
    // All outlines pass through centres. The first two are one triangle; the third shares its longest edge.
    const AdmittedScene scene = SceneBuilder({0, 0, 4, 4})
                                    .polygon({{.5, .5, 0}, {3.5, .5, 0}, {.5, 3.5, 0}})
                                    .polygon({{.5, 3.5, 0}, {.5, .5, 0}, {3.5, .5, 0}})
                                    .polygon({{3.5, .5, 0}, {3.5, 3.5, 0}, {.5, 3.5, 0}})
                                    .polygon({{.5, .5, 1}, {3.5, 3.5, 1}, {2, 2, .5}})
                                    .build();
    const Picture picture = Envelope(scene).picture();
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) CHECK(picture.at(x, y) == color_of(x + y <= 3 ? 0 : 2));
    }
    check_all_agree(scene);
}

TEST_CASE("The envelope tells apart what `double` does not") {
    // At the centre (1/2, 1/2) the second triangle is nearer by 2^-56, a quarter of an ulp.
    const AdmittedScene scene = SceneBuilder({0, 0, 1, 1})
                                    .polygon({{0, 0, .25}, {2, 0, .25}, {0, 2, .25}})
                                    .polygon({{0, 0, .25}, {2, 0, .25}, {0, 2, .25 + 0x1p-54}})
                                    .build();
    CHECK(Envelope(scene).picture().at(0, 0) == color_of(1));
    for (const Method method : {Method::warnock, Method::zbuffer}) {
        CHECK(render(method, scene, Double{}).at(0, 0) == color_of(0));
    }
    check_all_agree(scene);
}

TEST_CASE("Random and degenerate triangles") {
    RandomScenes random(20261122);
    for (int i = 0; i < 500; ++i) {
        CAPTURE(i);
        check_all_agree(triangulated(random.scene()));
    }
}

TEST_CASE("Triangles next to coincidences") {
    RandomScenes random(32);
    std::size_t wrong_in_double = 0;
    for (int i = 0; i < 500; ++i) {
        CAPTURE(i);
        const auto moved = moved_by_ulps(triangulated(random.scene()), random);
        REQUIRE(moved);
        const AdmittedScene& scene = *moved;
        check_pictures(scene);
        if (i % 10 == 0) check_regions(scene);
        wrong_in_double += different_pixels(render(Method::zbuffer, scene, Double{}), Envelope(scene).picture());
    }
    CHECK(wrong_in_double > 0);
}

TEST_CASE("Many triangles that interpenetrate") {
    const Area area{0, 0, 64, 64};
    const auto triangles = [&](int count) {
        RandomScenes random(7);
        SceneBuilder builder(area);
        for (int i = 0; i < count; ++i) builder.polygon(random.triangle(area));
        return builder.build();
    };
    check_pictures(triangles(100));
    check_regions(triangles(12));  // more triangles would make too many pieces and take minutes
}

TEST_CASE("Interpenetrating triangles") {
    // The third is level and passes through the line where the others meet.
    check_all_agree(SceneBuilder(area_16)
                        .polygon({{0, 1, 0}, {16, 8, 1}, {0, 15, 0}})
                        .polygon({{16, 1, 0}, {0, 8, 1}, {16, 15, 0}})
                        .polygon({{1, 0, .5}, {15, 0, .5}, {8, 16, .5}})
                        .build());
}

TEST_CASE("Cyclic overlap") {
    // The base of each triangle is in front of the tip of the previous one.
    check_all_agree(SceneBuilder(area_16)
                        .polygon({{1, 1, .75}, {1, 6, .75}, {16, 3, .25}})
                        .polygon({{15, 0, .75}, {9, 0, .75}, {9, 16, .25}})
                        .polygon({{14, 15, .75}, {6, 15, .75}, {2, 0, .25}})
                        .build());
}

TEST_CASE("A fan of triangles that share edges and a vertex") {
    const glm::dvec3 hub(7.5, 7.5, .5);
    const Corners rim{{0, 0, 0},   {7.5, -1, 0}, {16, 0, 0}, {17, 7.5, 0},
                      {16, 16, 0}, {7.5, 17, 0}, {0, 16, 0}, {-1, 7.5, 0}};
    SceneBuilder builder(area_16);
    for (std::size_t i = 0; i < rim.size(); ++i) builder.polygon({hub, rim[i], rim[(i + 1) % rim.size()]});
    check_all_agree(builder.build());
}

TEST_CASE("Coplanar overlaps") {
    // All lie in the plane z = x / 16; outlines cross each other on pixel centres.
    check_all_agree(SceneBuilder(area_16)
                        .polygon({{0, 0, 0}, {12, 0, .75}, {0, 12, 0}})
                        .polygon({{4, 4, .25}, {16, 4, 1}, {4, 16, .25}})
                        .polygon({{.5, 15.5, .03125}, {15.5, .5, .96875}, {15.5, 15.5, .96875}})
                        .build());
}
