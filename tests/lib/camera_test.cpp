/// From the world to the screen, with every place computed by hand.
#include "vidno/camera.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "vidno/look.h"

namespace {

using namespace vidno;

/// At the origin, looking along -z. tan(90 / 2 degrees) = 1: at distance d the view is 2 d high and, in a square, wide.
Camera ahead() {
    Camera camera;
    camera.eye = {0, 0, 0};
    camera.target = {0, 0, -1};
    camera.field_of_view = 90;
    camera.near_distance = 1;
    camera.far_distance = 3;
    return camera;
}

constexpr Area square{0, 0, 100, 100};

void check_close(const glm::dvec3& place, const glm::dvec3& expected) {
    CAPTURE(place.x);
    CAPTURE(place.y);
    CAPTURE(place.z);
    CHECK(std::abs(place.x - expected.x) < 1e-10);
    CHECK(std::abs(place.y - expected.y) < 1e-10);
    CHECK(std::abs(place.z - expected.z) < 1e-12);
}

std::string defect(const Camera& camera) { return std::string(defect_of(camera, square).value_or("none")); }

}  // namespace

TEST_CASE("the viewport maps -1 to 1 to the area, flips y and keeps z") {
    const glm::dmat4 matrix = viewport_matrix({10, 20, 6, 4});
    // x' = 3 x + 13, y' = -2 y + 22
    CHECK(matrix * glm::dvec4(-1, 1, 0.5, 1) == glm::dvec4(10, 20, 0.5, 1));
    CHECK(matrix * glm::dvec4(1, -1, -0.5, 1) == glm::dvec4(16, 24, -0.5, 1));
    CHECK(matrix * glm::dvec4(0, 0, 0, 1) == glm::dvec4(13, 22, 0, 1));
    CHECK(matrix * glm::dvec4(0, 0, 0, 2) == glm::dvec4(26, 44, 0, 2));
}

TEST_CASE("perspective: the greater z is nearer, 1 at the near plane and -1 at the far one") {
    const View view = view_of(ahead(), square);
    // z = A + B / d with z(1) = 1 and z(3) = -1: B = 3, A = -2. At d = 1.5, 2, 2.5: 0, -1/2, -4/5.
    // x = 50 + 50 x/d, y = 50 - 50 y/d.
    const auto seen = seen_by(view, {{-0.75, -0.75, -1.5}, {1, -1, -2}, {0, 1.25, -2.5}});
    REQUIRE(seen.size() == 3);
    check_close(seen[0], {25, 75, 0});
    check_close(seen[1], {75, 75, -0.5});
    check_close(seen[2], {50, 25, -0.8});
}

TEST_CASE("orthographic: depth is linear") {
    Camera camera = ahead();
    camera.projection = Projection::orthographic;
    camera.height = 4;
    // x = 50 + 25 x, y = 50 - 25 y, z = 2 - d
    const auto seen = seen_by(view_of(camera, square), {{-2, -2, -1}, {1, -2, -2}, {0, 2, -3}});
    REQUIRE(seen.size() == 3);
    check_close(seen[0], {0, 100, 1});
    check_close(seen[1], {75, 100, 0});
    check_close(seen[2], {50, 0, -1});
}

TEST_CASE("a wide area shows more at the sides, not less above") {
    // 200 x 100: x = 100 + 50 x/d, y = 50 - 50 y/d
    const auto seen = seen_by(view_of(ahead(), {0, 0, 200, 100}), {{-3, 0, -2}, {3, 0, -2}, {0, 1.5, -2}});
    REQUIRE(seen.size() == 3);
    check_close(seen[0], {25, 50, -0.5});
    check_close(seen[1], {175, 50, -0.5});
    check_close(seen[2], {100, 12.5, -0.5});
}

TEST_CASE("arbitrary eye, target and up") {
    Camera camera = ahead();
    camera.eye = {5, 0, 0};  // looking along -x with z upward: right is +y
    camera.target = {4, 0, 0};
    camera.up = {0, 0, 7};
    const auto seen = seen_by(view_of(camera, square), {{3, 1, 0}, {3, 0, 1}, {3, 0, 0}});
    REQUIRE(seen.size() == 3);
    check_close(seen[0], {75, 50, -0.5});
    check_close(seen[1], {50, 25, -0.5});
    check_close(seen[2], {50, 50, -0.5});
}

TEST_CASE("clipping to the view volume comes before the division") {
    const View view = view_of(ahead(), square);
    SUBCASE("in front of the near plane and behind the eye") {
        // The floor y = -1 from behind the eye (d = -1) to d = 2, between x = -1/2 and 1/2: cut at d = 1.
        const auto seen = seen_by(view, {{-0.5, -1, 1}, {0.5, -1, 1}, {0.5, -1, -2}, {-0.5, -1, -2}});
        REQUIRE(seen.size() == 4);
        check_close(seen[0], {75, 100, 1});
        check_close(seen[1], {62.5, 75, -0.5});
        check_close(seen[2], {37.5, 75, -0.5});
        check_close(seen[3], {25, 100, 1});
    }
    SUBCASE("at the sides") {
        // A triangle at d = 2 with a corner at x = 6, out to the right; the view there ends at x = 2. On the sides from
        // (6, 0) to (0, -1) and (0, 1) that is a third of the way from the left: y = -2/3 and 2/3.
        const auto seen = seen_by(view, {{6, 0, -2}, {0, 1, -2}, {0, -1, -2}});
        REQUIRE(seen.size() == 4);
        double right = 0;
        for (const auto& vertex : seen) right = std::max(right, vertex.x);
        CHECK(right == 100);  // exactly
    }
    SUBCASE("nothing is left") {
        CHECK(seen_by(view, {{0, 0, -4}, {1, 0, -4}, {0, 1, -4}}).empty());
        CHECK(seen_by(view, {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}).empty());
        CHECK(seen_by(view, {{9, 0, -2}, {8, 0, -2}, {9, 1, -2}}).empty());
    }
}

TEST_CASE("the image of a planar polygon under any camera is admitted") {
    Camera camera;
    camera.target = {0.1, 0.2, 0.3};
    camera.near_distance = 0.5;
    camera.far_distance = 40;
    int shown = 0;
    for (int i = 0; i < 200; ++i) {
        camera.eye = {7 * std::sin(i * 0.7), 3 * std::cos(i * 1.3), 7 * std::cos(i * 0.7)};
        const View view = view_of(camera, {-3, 5, 97, 61});
        const ScenePolygon floor{"F", {}, {{-9, -1, -9}, {9, -1, -9}, {9, -1, 9}, {-9, -1, 9}}};
        for (ScenePolygon polygon : look(view, floor).polygons) {
            ++shown;
            CHECK(admit_polygon(polygon).admission == Admission::admitted);
            for (const auto& vertex : polygon.vertices) {
                CHECK((-3 - 1e-9 <= vertex.x && vertex.x <= 94 + 1e-9));
                CHECK((5 - 1e-9 <= vertex.y && vertex.y <= 66 + 1e-9));
            }
        }
    }
    CHECK(shown >= 200);
}

TEST_CASE("cameras that see nothing are refused") {
    CHECK(defect(ahead()) == "none");
    const auto with = [](auto change) {
        Camera camera = ahead();
        change(camera);
        return defect(camera);
    };
    CHECK(with([](Camera& c) { c.target = c.eye; }) == "eye and target are one point");
    CHECK(with([](Camera& c) { c.up = {0, 0, 5}; }) == "up does not point aside from the direction of view");
    CHECK(with([](Camera& c) { c.up = {0, 0, 0}; }) == "up does not point aside from the direction of view");
    CHECK(with([](Camera& c) { c.near_distance = 0; }) == "near is not greater than 0");
    CHECK(with([](Camera& c) { c.near_distance = 3; }) == "near is not less than far");
    CHECK(with([](Camera& c) { c.field_of_view = 180; }) == "fov is not between 0 and 180 degrees");
    CHECK(with([](Camera& c) { c.field_of_view = std::nan(""); }) == "fov is not between 0 and 180 degrees");
    CHECK(with([](Camera& c) { c.eye.x = std::nan(""); }) == "not finite");
    CHECK(with([](Camera& c) { c.far_distance = std::numeric_limits<double>::infinity(); }) ==
          "out of the range of doubles");
    CHECK(with([](Camera& c) {
              c.projection = Projection::orthographic;
              c.height = 0;
          }) == "height is not greater than 0");
    CHECK(with([](Camera& c) {
              c.projection = Projection::orthographic;
              c.near_distance = -1;  // behind the eye is fine without perspective
          }) == "none");
}
