// The smallest scene with a property, and how little of a scene a picture needs.

#include "stability/shrink.h"

#include <doctest/doctest.h>

#include "stability/need.h"
#include "support/reference.h"
#include "support/scenes.h"
#include "vidno/snap.h"
#include "vidno/vidno.h"

using namespace vidno;
using namespace vidno::test;

namespace {

bool double_fails(const AdmittedScene& scene) {
    return render(Method::warnock, scene, Double{}) != Reference(scene).picture();
}

/// The scenes that have one polygon, one vertex or some binary places less.
std::vector<AdmittedScene> one_step_smaller(const AdmittedScene& scene) {
    std::vector<AdmittedScene> smaller;
    for (std::size_t polygon = 0; polygon < scene->polygons.size(); ++polygon) {
        smaller.push_back(without_polygon(scene, polygon));
        const auto& vertices = scene->polygons[polygon].vertices;
        for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex) {
            if (const auto fewer = without_vertex(scene, polygon, vertex)) smaller.push_back(*fewer);
            for (int axis = 0; axis < 3; ++axis) {
                for (int places = 0; places < binary_places(vertices[vertex][axis]); ++places) {
                    Scene rounded = scene;
                    auto& changed = rounded.polygons[polygon];
                    changed.vertices[vertex][axis] = snapped(vertices[vertex][axis], places);
                    if (admit_polygon(changed).admission == Admission::admitted)
                        smaller.push_back(admit(std::move(rounded)));
                }
            }
        }
    }
    return smaller;
}

Need need_of(const NeedReport& report, const std::string& what) {
    for (const auto& need : report.needs) {
        if (need.what == what) return need;
    }
    FAIL("nothing is said of " << what);
    return {};
}

}  // namespace

TEST_CASE("Binary places: how many of them a double has after the point") {
    CHECK(binary_places(0) == 0);
    CHECK(binary_places(-7) == 0);
    CHECK(binary_places(0x1p60) == 0);
    CHECK(binary_places(.5) == 1);
    CHECK(binary_places(-3.375) == 3);
    CHECK(binary_places(.1) == 55);  // 0x1.999999999999ap-4: four, and 52 but for the last, which is 0
    CHECK(binary_places(0x1p-1074) == 1074);
}

TEST_CASE("Shrinking: removes everything that the property does not need") {
    const AdmittedScene scene =
        SceneBuilder({0, 0, 8, 8})
            .quad(0, 0, 8, 8, -.5)
            .polygon("wanted", red, {{1.1, 1.3, .3}, {6.7, 1.3, .3}, {6.7, 6.1, .3}, {1.1, 6.1, .3}})
            .quad(5, 5, 8, 8, .7)
            .build();
    const auto shows_red = [](const AdmittedScene& smaller) { return Reference(smaller).picture().at(4, 2) == red; };
    const AdmittedScene smallest = shrunk(scene, shows_red);
    REQUIRE(smallest->polygons.size() == 1);
    CHECK(smallest->polygons[0].id == "wanted");
    CHECK(smallest->polygons[0].vertices.size() == 3);
    for (const auto& v : smallest->polygons[0].vertices) {
        CHECK(v == glm::dvec3(std::round(v.x), std::round(v.y), 0));
    }
    CHECK(smallest->area == scene->area);
}

TEST_CASE("Shrinking: nothing more can be removed") {
    RandomScenes random(31);
    int failures = 0;
    while (failures < 8) {
        const auto scene = moved_by_ulps(random.scene(), random);
        if (!scene || !double_fails(*scene)) continue;
        ++failures;
        const AdmittedScene smallest = shrunk(*scene, double_fails);
        CHECK(double_fails(smallest));
        for (const AdmittedScene& smaller : one_step_smaller(smallest)) CHECK_FALSE(double_fails(smaller));
    }
}

TEST_CASE("Need: a hidden polygon, and a plain one over the whole area") {
    const auto report =
        needs_of(SceneBuilder({0, 0, 4, 4}).polygon("front", red, far_quad).quad(0, 0, 4, 4, 0).build(), [] {});
    CHECK(report.least->polygons.size() == 1);
    CHECK(need_of(report, "polygons").amount == "1 of 2");
    CHECK(need_of(report, "polygons").one_lower == "without \"front\" pixel (0, 0) is #ffffff, not #ff0000");
    CHECK(need_of(report, "binary places of x and y").amount == "0 of 0");
    CHECK(need_of(report, "binary places of z").amount == "0 of 3");
    CHECK(need_of(report, "bits of arithmetic, warnock").amount == "4");
    CHECK(need_of(report, "bits of arithmetic, zbuffer").amount == "4");
    CHECK_MESSAGE(need_of(report, "levels of subdivision").amount == "0 of 2", "one window says it all");
}

TEST_CASE("Need: binary places, with the pixel that becomes wrong with one less") {
    // The right side at 2 7/16 excludes the centre 2 1/2. With three binary places 2 7/16 is a tie and rounds to 2 1/2.
    const auto report = needs_of(
        SceneBuilder({0, 0, 4, 1}).polygon("A", red, {{0, 0, 0}, {2.4375, 0, 0}, {2.4375, 1, 0}, {0, 1, 0}}).build(),
        [] {});
    CHECK(need_of(report, "binary places of x and y").amount == "4 of 4");
    CHECK(need_of(report, "binary places of x and y").one_lower == "with 3 pixel (2, 0) is #ff0000, not #ffffff");
}

TEST_CASE("Need: bits of arithmetic, and more than a double has") {
    // With four bits the side at 8 1/4 is 8, and so is the centre 8 1/2, which lies beyond it.
    const auto of_side = [](double right) {
        return need_of(needs_of(SceneBuilder({0, 0, 16, 1}).quad(0, 0, right, 1, 0).build(), [] {}),
                       "bits of arithmetic, zbuffer");
    };
    CHECK(of_side(8.25).amount == "5");
    CHECK(of_side(8.25).one_lower == "with 4 pixel (8, 0) is #0100c8, not #ffffff");
    // At the first pixel's centre the second triangle is nearer by 2^-55, half an ulp.
    const AdmittedScene close = SceneBuilder({0, 0, 2, 1})
                                    .polygon({{-1, 0, .25}, {3, 0, .25}, {1, 2, .25}})
                                    .polygon({{0, 0, .25}, {1, 0, .25}, {.5, 1, .25 + 0x1p-54}})
                                    .build();
    const auto report = needs_of(close, [] {});
    for (const std::string method : {"warnock", "zbuffer"}) {
        const Need bits = need_of(report, "bits of arithmetic, " + method);
        CHECK(bits.amount == "more than 53");
        CHECK(bits.one_lower == "with double pixel (0, 0) is #0100c8, not #0228b4");
    }
}

TEST_CASE("Need: levels of subdivision") {
    // The left half of the area: two windows of half its side, each simple, so one level of three.
    const auto report = needs_of(SceneBuilder({0, 0, 8, 8}).quad(-1, -1, 4, 9, 0).quad(4, -1, 9, 9, .5).build(), [] {});
    CHECK(need_of(report, "levels of subdivision").amount == "1 of 3");
}
