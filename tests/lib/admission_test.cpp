/// Which polygons are admitted, decided exactly. A polygon is given by its corners.
#include "vidno/admission.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "vidno/look.h"

namespace {

using namespace vidno;

ScenePolygon polygon_of(std::vector<glm::dvec3> vertices) { return {"P", {}, std::move(vertices)}; }

std::string verdict(std::vector<glm::dvec3> vertices) {
    ScenePolygon polygon = polygon_of(std::move(vertices));
    const PolygonAdmission admitted = admit_polygon(polygon);
    if (admitted.admission == Admission::admitted && polygon.edge_on) return "edge-on";
    return std::string(reason_of(admitted.admission));
}

/// An outline that starts at each of its vertices, in both directions.
std::vector<std::vector<glm::dvec3>> turned(std::vector<glm::dvec3> vertices) {
    std::vector<std::vector<glm::dvec3>> all;
    for (int way = 0; way < 2; ++way) {
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
            all.push_back(vertices);
        }
        std::reverse(vertices.begin(), vertices.end());
    }
    return all;
}

void check_all(const std::string& expected, const std::vector<glm::dvec3>& vertices) {
    for (const auto& outline : turned(vertices)) CHECK(verdict(outline) == expected);
}

constexpr const char* not_convex = "not convex: the outline does not go once around the convex hull of its vertices";
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least = std::numeric_limits<double>::denorm_min();

}  // namespace

TEST_CASE("a polygon has at least three finite vertices, with z from -1 to 1, both included") {
    CHECK(verdict({}) == "fewer than three vertices");
    CHECK(verdict({{0, 0, 0}, {1, 0, 0}}) == "fewer than three vertices");
    CHECK(verdict({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}) == "not finite");
    CHECK(verdict({{0, 0, 0}, {1, 0, 0}, {0, 1, infinity}}) == "not finite");
    CHECK(verdict({{0, 0, -1}, {1, 0, 1}, {0, 1, 0}}) == "admitted");
    CHECK(verdict({{0, 0, 0}, {1, 0, std::nextafter(1.0, 2.0)}, {0, 1, 0}}) == "z outside -1 to 1");
    CHECK(verdict({{0, 0, 0}, {1, 0, std::nextafter(-1.0, -2.0)}, {0, 1, 0}}) == "z outside -1 to 1");
}

TEST_CASE("convex outlines are admitted from every vertex and in both directions") {
    check_all("admitted", {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}});
    check_all("admitted", {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
    check_all("admitted", {{2, 0, 0}, {6, 1, 0}, {7, 5, 0}, {4, 8, 0}, {0, 4, 0}});
}

TEST_CASE("repeated and collinear vertices are allowed and stay") {
    check_all("admitted", {{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 4, 0}, {0, 4, 0}, {0, 2, 0}});
    ScenePolygon polygon = polygon_of({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 4, 0}});
    CHECK(admit_polygon(polygon).dropped == 0);
    CHECK(polygon.vertices.size() == 5);
}

TEST_CASE("outlines that are not convex or do not wind around exactly once are refused") {
    // An L, and a quad with a dent.
    check_all(not_convex, {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
    check_all(not_convex, {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});
    // A bow-tie: the turns differ in sign.
    check_all(not_convex, {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}});
    // A pentagram: five turns of one sign, but it winds around twice, so the direction flips four times.
    check_all(not_convex, {{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}});
    // A square traversed twice.
    check_all(not_convex, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
    // Spikes: out of a corner, out of a side, and back along a side.
    check_all(not_convex, {{0, 0, 0}, {3, 0, 0}, {2, 0, 0}, {0, 2, 0}});
    check_all(not_convex, {{0, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}});
    check_all(not_convex, {{0, 0, 0}, {3, 0, 0}, {1, 0, 0}, {4, 0, 0}, {0, 4, 0}});
}

TEST_CASE("edge-on is decided exactly, whatever the order of the vertices") {
    CHECK(verdict({{0, 0, 0}, {1, 1, .1}, {2, 2, .2}}) == "edge-on");
    CHECK(verdict({{0, 0, 0}, {4, 0, 0}, {2, 0, .5}, {6, 0, -.5}, {1, 0, 1}}) == "edge-on");
    CHECK(verdict({{3, 3, 0}, {3, 3, 1}, {3, 3, -1}}) == "edge-on");
    // On y = 3 x as decimals, but not as doubles.
    CHECK(verdict({{0.1, 0.3, 0}, {0.2, 0.6, 0}, {0.3, 0.9, 0}}) == "admitted");
    // One unit in the last place off the diagonal.
    CHECK(verdict({{0, 0, 0}, {1, 1, 0}, {3, std::nextafter(3.0, 4.0), 0}}) == "admitted");
    // Where a product of the differences would overflow, or underflow to 0.
    CHECK(verdict({{-1e300, -1e300, 0}, {0, 0, 0}, {1e300, 1e300, 0}}) == "edge-on");
    CHECK(verdict({{-1e300, -1e300, 0}, {0, 1, 0}, {1e300, 1e300, 0}}) == "admitted");
    CHECK(verdict({{0, 0, 0}, {least, 0, 0}, {0, least, 0}}) == "admitted");
    CHECK(verdict({{-1e308, -1e308, 0}, {1e308, -1e308, 0}, {1e308, 1e308, 0}, {-1e308, 1e308, 0}}) == "admitted");
}

TEST_CASE("planar within 2^-40 of the extent") {
    // The square with corners (0,0), (1,0), (1,1), (0,1) and one corner raised by 4h. Newell's sum about the first is a
    // = -4h, b = -4h, c = 2 to first order for the corner (1,1). The plane z = 2h (x + y) passes 2h below or above the
    // corners (1,0) and (0,1), and through (1,1). So 2h is compared with 2^-40: h = 2^-41 is the limit, up to a factor
    // of 1 + 8 h^2.
    const auto raised = [](double h) {
        return std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 4 * h}, {0, 1, 0}};
    };
    CHECK(verdict(raised(0)) == "admitted");
    CHECK(verdict(raised(0x1p-41)) == "admitted");
    CHECK(verdict(raised(0x1.001p-41)) == "not planar");
    CHECK(verdict(raised(-0x1p-41)) == "admitted");
    CHECK(verdict(raised(0.125)) == "not planar");
    CHECK(verdict({{0, 0, 0}, {1e-300, 0, 0}, {1e-300, 1e-300, 1e-301}, {0, 1e-300, 0}}) == "not planar");
    // Any three points lie in a plane.
    CHECK(verdict({{0.1, 0.7, 0.3}, {1e9, -3, 0.9}, {7, 1e-9, -0.123}}) == "admitted");
}

TEST_CASE("a vertex reflex by at most 2^-40 of the extent is dropped") {
    // The square from 0 to 1 with a vertex in the middle of its first side, pushed inwards by h: the extent is 1.
    const auto dented = [](double h) {
        return std::vector<glm::dvec3>{{0, 0, 0}, {0.5, h, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    };
    for (const double h : {0x1p-1074, 0x1p-60, 0x1p-40}) {
        for (const auto& outline : turned(dented(h))) {
            ScenePolygon polygon = polygon_of(outline);
            const PolygonAdmission admitted = admit_polygon(polygon);
            CHECK(admitted.admission == Admission::admitted);
            CHECK(admitted.dropped == 1);
            CHECK(polygon.vertices.size() == 4);
        }
    }
    check_all(not_convex, dented(std::nextafter(0x1p-40, 1.0)));
    check_all("admitted", dented(-0x1p-30));  // outwards it is not a dent
}

TEST_CASE("many vertices reflex by rounding are dropped, but a deep dent is not removed step by step") {
    // A bay of n + 1 points along y = d (x - x^2) seen from above a unit square: d / 4 deep in the middle.
    const auto bay = [](double d) {
        std::vector<glm::dvec3> outline;
        constexpr int n = 64;
        for (int i = 0; i <= n; ++i) {
            const double x = double(i) / n;
            outline.push_back({x, d * (x - x * x), 0});
        }
        outline.push_back({1, 1, 0});
        outline.push_back({0, 1, 0});
        return outline;
    };
    ScenePolygon polygon = polygon_of(bay(0x1p-38));
    CHECK(admit_polygon(polygon).dropped == 63);
    CHECK(polygon.vertices.size() == 4);
    // Each vertex is only 2^-36 / 64^2 = 2^-48 off its neighbours' chord, the middle one 2^-38 off the last chord.
    CHECK(verdict(bay(0x1p-36)) == not_convex);
}

TEST_CASE("an outline may overrun its start by rounding, wherever it starts and in both directions") {
    constexpr double ulp = 0x1p-52;  // of 1
    // A square from (1, 1) to (2, 2) with a last vertex that lies past the first: along the first side, beyond it, and
    // before it.
    for (const double beyond : {0.0, -3 * ulp, 3 * ulp}) {
        CAPTURE(beyond);
        check_all("admitted", {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1 + 3 * ulp, 1 + beyond, 0}});
        check_all("admitted",
                  {{1.5, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {1.5 + 3 * ulp, 1 + beyond, 0}});
    }
    // Steps at a corner. In the first two all turns have one sign, but there the outline winds around once more.
    const auto with_step = [](std::vector<glm::dvec3> step) {
        for (const glm::dvec3 rest : {glm::dvec3{2, 1, 0}, {2, 2, 0}, {1, 2, 0}}) step.push_back(rest);
        return step;
    };
    check_all("admitted", with_step({{1, 1, 0}, {1 + 3 * ulp, 1 - ulp, 0}, {1 - ulp, 1 + ulp, 0}}));
    check_all("admitted", with_step({{1, 1, 0}, {1 + 3 * ulp, 1 + 4 * ulp, 0}, {1 - 4 * ulp, 1, 0}}));
    check_all("admitted", with_step({{1, 1, 0}, {1 + 3 * ulp, 1 - 2 * ulp, 0}, {1, 1, 0}}));
    // The overrun that the tolerance no longer admits: the extent is 1.
    check_all("admitted", {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1 + 0x1p-40, 1, 0}});
    check_all(not_convex, {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1 + 0x1p-40 + ulp, 1, 0}});
}

TEST_CASE("an outline that is convex but for rounding keeps the corners of its hull, from its first one") {
    ScenePolygon polygon = polygon_of({{0, 4, 0}, {0, 0, 0}, {2, 0x1p-60, 0}, {3, 0, 0}, {4, 0, 0}, {4, 4, 0}});
    CHECK(admit_polygon(polygon).dropped == 2);
    CHECK(polygon.vertices == std::vector<glm::dvec3>{{0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}});
}

TEST_CASE("in the world a polygon is seen along the axis nearest to its normal") {
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        ScenePolygon square = polygon_of(seen_along(axis, {{0, 0, 9}, {4, 0, 9}, {4, 4, 9}, {0, 4, 9}}));
        const auto vertices = square.vertices;
        CHECK(admit_in_world(square).admission == Admission::admitted);
        CHECK_FALSE(square.edge_on);
        CHECK(square.vertices == vertices);

        ScenePolygon dent = polygon_of(seen_along(axis, {{0, 0, 9}, {4, 0, 9}, {1, 1, 9}, {0, 4, 9}}));
        CHECK(admit_in_world(dent).admission == Admission::not_convex);
    }
    ScenePolygon line = polygon_of({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}});
    admit_in_world(line);
    CHECK(line.edge_on);  // from anywhere
}
