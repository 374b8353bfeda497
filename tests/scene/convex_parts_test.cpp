// Polygons that are not convex are cut into convex parts when a scene is read.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scene/exact_scene.h"
#include "scene/scene_json.h"

namespace {

using namespace vidno;

using Vertices = std::vector<glm::dvec3>;

/// Twice the area on the screen; exact for small whole coordinates.
double double_area(const Vertices& vertices) {
    double sum = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto &p = vertices[i], &q = vertices[(i + 1) % vertices.size()];
        sum += p.x * q.y - p.y * q.x;
    }
    return sum;
}

/// The edges of all parts, without those that two parts have in opposite directions.
std::vector<std::pair<std::string, std::string>> outer_edges(const std::vector<Vertices>& parts) {
    const auto text = [](const glm::dvec3& p) { return std::to_string(p.x) + " " + std::to_string(p.y); };
    std::map<std::pair<std::string, std::string>, int> count;
    for (const auto& part : parts) {
        for (std::size_t i = 0; i < part.size(); ++i) ++count[{text(part[i]), text(part[(i + 1) % part.size()])}];
    }
    std::vector<std::pair<std::string, std::string>> outer;
    for (const auto& [edge, times] : count) {
        const auto back = count.find({edge.second, edge.first});
        const int left = times - (back == count.end() ? 0 : back->second);
        for (int i = 0; i < left; ++i) outer.push_back(edge);
    }
    return outer;
}

std::vector<Vertices> parts_of(const Vertices& outline) {
    std::vector<Vertices> parts;
    for (const auto& part : exact_scene::cut_into_convex_parts({"A", {}, outline})) parts.push_back(part.vertices);
    return parts;
}

/// Checks that the parts are convex, cover the outline and meet along whole edges.
void check_parts(const Vertices& outline, const std::vector<Vertices>& parts) {
    double area = 0;
    for (const Vertices& part : parts) {
        ScenePolygon alone{"A", {}, part};
        CHECK(exact_scene::admit_polygon(alone).admission == Admission::admitted);
        CHECK_MESSAGE(double_area(part) * double_area(outline) > 0, "a part has the orientation of the outline");
        area += double_area(part);
    }
    CHECK(area == double_area(outline));
    CHECK(outer_edges(parts) == outer_edges({outline}));
}

struct Shape {
    const char* name;
    Vertices outline;
    std::size_t reflex;  // the number of reflex vertices
};

const std::vector<Shape> shapes{
    {"L", {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}}, 1},
    {"dart", {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, 1},
    {"U", {{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {4, 4, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}}, 2},
    {"plus, with the corners of its middle as reflex vertices",
     {{1, 0, 0},
      {2, 0, 0},
      {2, 1, 0},
      {3, 1, 0},
      {3, 2, 0},
      {2, 2, 0},
      {2, 3, 0},
      {1, 3, 0},
      {1, 2, 0},
      {0, 2, 0},
      {0, 1, 0},
      {1, 1, 0}},
     4},
    {"L with vertices on its edges and in line with its reflex vertex",
     {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {3, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}, {0, 2, 0}},
     1},
    {"a square with a square hole, bridged",
     {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {0, 0, 0}, {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}, {2, 2, 0}},
     4},
    {"tilted arrow", {{0, 2, .125}, {4, 0, .25}, {4, 1, .25}, {8, 1, .5}, {8, 3, .5}, {4, 3, .25}, {4, 4, .25}}, 2},
};

std::string scene_of(const std::string& polygons) {
    return R"({"window":{"x":0,"y":0,"width":8,"height":8},"polygons":[)" + polygons + "]}";
}

}  // namespace

TEST_CASE("Convex parts: few, convex, and together the polygon") {
    for (const auto& [name, outline, reflex] : shapes) {
        const auto& shown_name = name;
        CAPTURE(shown_name);
        Vertices turned = outline;
        for (std::size_t turn = 0; turn < outline.size(); ++turn) {
            const auto parts = parts_of(turned);
            CHECK(parts.size() >= 2);
            CHECK_MESSAGE(parts.size() <= 2 * reflex + 1, "each reflex vertex needs two diagonals at most");
            check_parts(turned, parts);
            std::rotate(turned.begin(), turned.begin() + 1, turned.end());
        }
        std::reverse(turned.begin(), turned.end());
        check_parts(turned, parts_of(turned));
    }
}

TEST_CASE("Convex parts: random star-shaped outlines") {
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        const int count = 5 + int(random() % 20);
        Vertices outline;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count, radius = 100 + double(random() % 900);
            outline.emplace_back(std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle)), 0);
        }
        ScenePolygon whole{"A", {}, outline};
        if (exact_scene::admit_polygon(whole).admission != Admission::not_convex) continue;
        CAPTURE(i);
        const auto parts = parts_of(outline);
        CHECK(!parts.empty());
        check_parts(outline, parts);
    }
}

TEST_CASE("Convex parts: a comb of 100 teeth has a part for each and one for its back") {
    Vertices comb{{0, 0, 0}, {201, 0, 0}, {201, 1, 0}};
    for (int tooth = 100; tooth > 0; --tooth) {
        const double left = 2. * tooth - 1;
        comb.emplace_back(left + 0.5, 9, 0);
        comb.emplace_back(left - 0.5, 1, 0);
    }
    const auto parts = parts_of(comb);
    double area = 0;
    for (const auto& part : parts) area += double_area(part);
    CHECK(area == double_area(comb));
    CHECK(parts.size() <= 400);  // four times as many as necessary, at most
}

TEST_CASE("Convex parts: an outline that crosses itself, or goes around twice, has none") {
    for (const Vertices& outline : std::vector<Vertices>{
             {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}},
             {{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}},
             {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
             {{0, 0, 0}, {2, 2, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {0, 4, 0}, {2, 2, 0}, {1, 5, 0}},
         }) {
        CAPTURE(outline.size());
        CHECK(parts_of(outline).empty());
    }
}

TEST_CASE("A polygon of a scene that is not convex becomes parts of one face and colour") {
    const auto [scene, warnings] = read_scene(
        scene_of(R"({"id":"L","color":"#102030","vertices":[[0,0,0],[4,0,0],[4,2,0],[2,2,0],[2,4,0],[0,4,0]]},)"
                 R"({"id":"L.1","vertices":[[0,0,1],[1,0,1],[0,1,1]]})"),
        "f.json");
    REQUIRE(scene->polygons.size() == 3);
    CHECK(scene->polygons[0].id == "L.2");  // L.1 is taken
    CHECK(scene->polygons[1].id == "L.3");
    for (const std::size_t i : {0, 1}) {
        CHECK(scene->polygons[i].face == "L");
        CHECK(scene->polygons[i].color == Color{0x10, 0x20, 0x30});
    }
    CHECK(scene->polygons[2].face.empty());
    CHECK(warnings == std::vector<std::string>{"f.json: /polygons/0: not convex, cut into 2 convex polygons"});
    CHECK_MESSAGE(read_scene(scene_json(*scene), "again").scene == scene, "parts are read back as they are");
}

TEST_CASE("A polygon of the world that is not convex is cut before it is seen") {
    const std::string camera = R"("camera":{"eye":[2,2,50],"target":[2,2,0],"projection":"orthographic",)"
                               R"("height":8,"near":1,"far":99},)";
    std::string text = scene_of(R"({"id":"L","vertices":[[0,0,0],[4,0,0],[4,2,0],[2,2,0],[2,4,0],[0,4,0]]})");
    text.insert(1, camera);
    const auto [scene, warnings] = read_scene(text, "f.json");
    REQUIRE(scene->polygons.size() == 2);
    // 8 pixels show 8 units, so the L keeps its area of 12.
    CHECK(std::abs(double_area(scene->polygons[0].vertices)) + std::abs(double_area(scene->polygons[1].vertices)) ==
          24);
    CHECK(scene->polygons[1].face == "L");
}

TEST_CASE("A bent polygon is refused with the vertex, the plane and the depth that would do") {
    const auto fault = [](const Vertices& vertices) {
        const auto [vertex, reason] = exact_scene::fault_of_shape({"A", {}, vertices}, Admission::not_planar, false);
        return std::pair(vertex.value_or(99), reason);
    };
    const auto said = [](const std::string& plane, const std::string& depth) {
        return "not planar: in the plane of " + plane + " this vertex would have z = " + depth +
               "; triangles are always planar";
    };
    // The plane z = y / 4.
    CHECK(fault({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}) ==
          std::pair(std::size_t(3), said("[0,0,0], [4,0,0] and [4,4,1]", "1")));
    // All but vertex 1 are in the plane z = x / 8.
    CHECK(fault({{0, 0, 0}, {4, 0, .75}, {4, 4, .5}, {2, 5, .25}, {0, 4, 0}}) ==
          std::pair(std::size_t(1), said("[0,0,0], [4,4,0.5] and [2,5,0.25]", "0.5")));
}
