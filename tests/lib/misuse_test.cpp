/// Wrong uses of the library do not compile or throw; they never draw a wrong picture, run forever or crash.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "support/curves.h"
#include "support/scenes.h"
#include "vidno/admission.h"
#include "vidno/family/family.h"
#include "vidno/floating_horizon.h"
#include "vidno/kernels/exact.h"
#include "vidno/kernels/filtered.h"
#include "vidno/kernels/filtered_regions.h"
#include "vidno/vidno.h"
#include "vidno/weiler_atherton.h"

namespace {

using namespace vidno;
using namespace vidno::test;

template <class S>
concept Renderable = requires(const S& scene) {
    render(Method::warnock, scene, Double{});
};
template <class S>
concept HasVisibleRegions = requires(const S& scene) {
    visible_regions(scene, Double{});
};
template <class S>
concept HasVisibleLines = requires(const S& curves) {
    visible_lines(curves, Double{});
};

// A scene that was not admitted does not compile.
static_assert(Renderable<AdmittedScene> && !Renderable<Scene>);
static_assert(HasVisibleRegions<AdmittedScene> && !HasVisibleRegions<Scene>);
static_assert(HasVisibleLines<AdmittedCurves> && !HasVisibleLines<CurveScene>);

Scene with_area(const Area& area) { return {.name = {}, .area = area, .background = white, .polygons = {}}; }

Scene with_polygon(Corners vertices) {
    Scene scene = with_area(area_16);
    scene.polygons.push_back({.id = "P", .color = red, .vertices = std::move(vertices)});
    return scene;
}

CurveScene with_curve(std::vector<Sample> samples) { return {{0, 0, 4, 4}, {{std::move(samples)}}}; }

}  // namespace

TEST_CASE("A method that does not belong to the procedure set is refused") {
    const AdmittedScene scene = small_scene();
    for (const Method method :
         {Method::warnock_full, Method::warnock_simplest, Method::warnock_edges, Method::weiler_atherton}) {
        CHECK_THROWS_AS(render(method, scene, Double{}), std::invalid_argument);
    }
    CHECK_THROWS_AS(render<family::Full>(Method::warnock_edges, scene, Double{}), std::invalid_argument);
}

TEST_CASE("A smallest window below one pixel, which no window would reach, is refused") {
    const AdmittedScene scene = small_scene();
    for (const double side : {.5, 0., -1., std::nan("")}) {
        CAPTURE(side);
        CHECK_THROWS_WITH_AS(render(Method::warnock, scene, Double{}, NoTrace{}, side),
                             "the smallest window is smaller than a pixel", std::invalid_argument);
    }
}

TEST_CASE("A polygon that is not admitted is refused by its name and with the reason") {
    CHECK_THROWS_WITH_AS(admit(with_polygon({})), "polygon \"P\": fewer than three vertices", std::invalid_argument);
    CHECK_THROWS_WITH_AS(admit(with_polygon({{0, 0, 0}, {9, 0, 0}, {0, std::nan(""), 0}})), "polygon \"P\": not finite",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(admit(with_polygon({{0, 0, 0}, {9, 0, 2}, {0, 9, 0}})), "polygon \"P\": z outside -1 to 1",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(
        admit(with_polygon({{0, 0, 0}, {9, 0, 0}, {2, 2, 0}, {0, 9, 0}})),
        "polygon \"P\": not convex: the outline does not go once around the convex hull of its vertices",
        std::invalid_argument);
}

TEST_CASE_TEMPLATE("Admission finds an edge-on polygon, and every method then shows nothing of it", K, Double, Filtered,
                   Exact) {
    const AdmittedScene scene = admit(with_polygon({{1, 1, 0}, {5, 5, .5}, {9, 9, -.5}}));
    CHECK(scene->polygons[0].edge_on);
    const Picture background(area_16, white);
    CHECK(render(Method::warnock, scene, K{}) == background);
    CHECK(render(Method::zbuffer, scene, K{}) == background);
    CHECK(visible_regions(scene, K{}).regions.empty());
}

TEST_CASE("An area beyond the limits is refused") {
    const char* const side = "the area has a side that is not 1 to 16384";
    CHECK_THROWS_WITH_AS(admit(with_area({0, 0, -3, 4})), side, std::invalid_argument);
    CHECK_THROWS_WITH_AS(admit(with_area({0, 0, 4, 0})), side, std::invalid_argument);
    CHECK_THROWS_WITH_AS(admit(with_area({0, 0, largest_side + 1, 4})), side, std::invalid_argument);
    // x + width would overflow.
    CHECK_THROWS_WITH_AS(admit(with_area({std::numeric_limits<int>::max() - 2, 0, 4, 4})),
                         "the area starts farther than 2^30 from 0", std::invalid_argument);
    CHECK(admit(with_area({farthest_offset, -farthest_offset, largest_side, 1}))->area.right() ==
          farthest_offset + largest_side);
}

TEST_CASE("Curves that leave the area's columns are refused, and heights that are not finite are gaps") {
    const char* const columns = "curve 0: fewer than two samples, or they do not grow within the area's columns";
    CHECK_THROWS_WITH_AS(admit(with_curve({})), columns, std::invalid_argument);
    CHECK_THROWS_WITH_AS(admit(with_curve({{0, 1}})), columns, std::invalid_argument);
    CHECK_THROWS_WITH_AS(admit(with_curve({{0, 1}, {900, 2}})), columns, std::invalid_argument);
    CHECK_THROWS_WITH_AS(admit(with_curve({{2, 1}, {1, 2}})), columns, std::invalid_argument);
    CHECK(pieces_of(admit(with_curve({{0, 1}, {3, std::nan("")}}))->curves[0]).empty());
    CHECK(pieces_of(admit(with_curve({{0, 1}, {1, 1}, {2, HUGE_VAL}, {3, 1}}))->curves[0]).size() == 1);
    CHECK(admit(with_curve({{0, 1}, {3, 2}}))->curves.size() == 1);
}
