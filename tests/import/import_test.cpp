/// Meshes: the same cube in every format, faces that must be cut, and files with false headers.
#include "import/import.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "refused.h"
#include "scene/scene_json.h"

namespace {

using namespace vidno;

constexpr std::array<std::array<int, 3>, 8> cube_points{
    {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}}};
constexpr std::array<std::array<int, 4>, 6> cube_faces{
    {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}};

std::string text_points(const std::string& before_each) {
    std::string out;
    for (const auto& [x, y, z] : cube_points) {
        out += before_each + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    }
    return out;
}

std::string text_faces(const std::string& before_each, int first_index) {
    std::string out;
    for (const auto& face : cube_faces) {
        out += before_each;
        for (const int i : face) out += " " + std::to_string(i + first_index);
        out += "\n";
    }
    return out;
}

template <class Value>
std::string bytes_of(Value value, bool big_endian = false) {
    auto bytes = std::bit_cast<std::array<char, sizeof value>>(value);
    if (big_endian) std::reverse(bytes.begin(), bytes.end());
    return {bytes.data(), bytes.size()};
}

std::string ply_header(const std::string& format, const std::string& points = "8", const std::string& faces = "6") {
    return "ply\nformat " + format + " 1.0\ncomment a cube\nelement vertex " + points +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string binary_ply(bool big_endian) {
    std::string out = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian");
    for (const auto& point : cube_points) {
        for (const int coordinate : point) out += bytes_of(float(coordinate), big_endian);
    }
    for (const auto& face : cube_faces) {
        out += '\4';
        for (const int i : face) out += bytes_of(std::int32_t(i), big_endian);
    }
    return out;
}

/// Two triangles a face, 12 in all. The header begins like text, as those of many programs do.
std::string binary_stl(std::uint32_t said = 12) {
    std::string out = "solid of two triangles a face";
    out.resize(80, ' ');
    out += bytes_of(said);
    for (const auto& face : cube_faces) {
        for (const int second : {1, 2}) {
            out += std::string(12, '\0');  // the normal
            for (const int corner : {0, second, second + 1}) {
                for (const int coordinate : cube_points[std::size_t(face[std::size_t(corner)])]) {
                    out += bytes_of(float(coordinate));
                }
            }
            out += std::string(2, '\0');
        }
    }
    return out;
}

std::string text_stl() {
    return "solid of one facet\nfacet normal nan nan nan\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n"
           "  vertex 0 1 0\n endloop\nendfacet\nendsolid of one facet\n";
}

std::string cube_obj() { return "# a cube\n" + text_points("v ") + "usemtl grey\n" + text_faces("f", 1); }
std::string cube_off() { return "OFF\n# a cube\n8 6 12\n" + text_points("") + text_faces("4", 0); }
std::string cube_ply() { return ply_header("ascii") + text_points("") + text_faces("4", 0); }

/// Looking along -z from (0, 0, 9): 20 high on 20 pixels, so that x' = 10 + x and y' = 10 - y.
ImportOptions from_the_front() {
    ImportOptions options;
    options.width = options.height = 20;
    options.camera.emplace();
    options.camera->eye = {0, 0, 9};
    options.camera->projection = Projection::orthographic;
    options.camera->height = 20;
    options.camera->near_distance = 4;
    options.camera->far_distance = 14;
    return options;
}

std::vector<std::string> ids(const AdmittedScene& scene) {
    std::vector<std::string> out;
    for (const auto& polygon : scene->polygons) out.push_back(polygon.id);
    return out;
}

std::string message_for(const std::string& bytes, const std::string& file) {
    try {
        import_mesh(bytes, file, {});
        return "taken";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

}  // namespace

TEST_CASE("a cube in every format is the same scene") {
    const auto [scene, warnings] = import_mesh(cube_obj(), "models/cube.obj", {});
    CHECK(warnings == std::vector<std::string>{"models/cube.obj: 6 faces read, 0 dropped"});
    CHECK(scene->name == "cube");
    CHECK(scene->area == Area{0, 0, 128, 128});
    CHECK(ids(scene) == std::vector<std::string>{"0", "1", "2", "3", "4", "5"});
    for (const auto& polygon : scene->polygons) {
        CHECK(polygon.vertices.size() == 4);
        for (const auto& vertex : polygon.vertices) {
            CHECK((0 < vertex.x && vertex.x < 128 && 0 < vertex.y && vertex.y < 128));
        }
    }
    CHECK(read_scene(scene_json(scene), "again.json").scene == scene);

    CHECK(import_mesh(cube_off(), "cube.off", {}).scene == scene);
    CHECK(import_mesh(cube_ply(), "cube.ply", {}).scene == scene);
    CHECK(import_mesh(binary_ply(false), "cube.PLY", {}).scene == scene);
    CHECK(import_mesh(binary_ply(true), "cube.ply", {}).scene == scene);
    CHECK(import_mesh(binary_stl(), "cube.stl", {}).scene->polygons.size() == 12);
    CHECK(import_mesh(text_stl(), "cube.stl", {}).scene->polygons.size() == 1);
}

TEST_CASE("faces that face the viewer are lighter") {
    // The default camera stands in front (+z), a little above (+y) and to the right (+x).
    const AdmittedScene scene = import_mesh(cube_obj(), "cube.obj", {}).scene;
    const auto light = [&](std::size_t face) { return int(scene->polygons[face].color.green); };
    CHECK(light(5) > light(1));  // z = 1 against x = 1
}

TEST_CASE("OBJ: corners with normals, indices from the end, tabs, continued lines, anything else passed over") {
    const std::string points = "v 0 0 0\nv 4 0 0\nv 0 4 0 1.0\r\nvn 0 0 1\n";
    for (const std::string face :
         {"f 1 2 3\n", "f 1/1/1 2//1 3/2\n", "f -3 -2 -1\n", "f\t1\t2\t3\r\n", "f 1 2 \\\n3"}) {
        CAPTURE(face);
        const AdmittedScene scene = import_mesh(points + "l 1 2\n" + face, "t.obj", from_the_front()).scene;
        REQUIRE(scene->polygons.size() == 1);
        // z: 1 at distance 4, -1 at distance 14; at 9 it is 0.
        CHECK(scene->polygons[0].vertices == std::vector<glm::dvec3>{{10, 10, 0}, {14, 10, 0}, {10, 6, 0}});
    }
}

TEST_CASE("OFF with colours and normals") {
    const std::string text = "CNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255\n4 0 0 0 0 1 9 9 9 9\n0 4 0\n3 0 1 2 0.5 0.5 0.5\n";
    CHECK(import_mesh(text, "t.off", from_the_front()).scene->polygons.size() == 1);
}

TEST_CASE("PLY with other elements, other types and unused lists") {
    const std::string text =
        "ply\nformat ascii 1.0\nelement material 1\nproperty int k\nproperty list uchar float weights\n"
        "element vertex 3\nproperty uchar red\nproperty double z\nproperty double y\nproperty int x\n"
        "element face 1\nproperty list uchar uchar vertex_index\nproperty float quality\nend_header\n"
        "7 2 0.5 0.5\n255 0 0 0\n255 0 0 4\n255 0 4 0\n3 0 1 2 0.1\n";
    const AdmittedScene scene = import_mesh(text, "t.ply", from_the_front()).scene;
    REQUIRE(scene->polygons.size() == 1);
    CHECK(scene->polygons[0].vertices == std::vector<glm::dvec3>{{10, 10, 0}, {14, 10, 0}, {10, 6, 0}});
}

/// The sum of the polygons' areas on the screen.
static double area_of(const Scene& scene) {
    double area = 0;
    for (const auto& [id, color, v, edge_on, face] : scene.polygons) {
        double twice = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            const auto &p = v[i], &q = v[(i + 1) % v.size()];
            twice += p.x * q.y - p.y * q.x;
        }
        area += std::abs(twice) / 2;
    }
    return area;
}

TEST_CASE("faces that are not planar or not convex are cut into convex polygons") {
    SUBCASE("a quad with a raised corner: 2 triangles") {
        const auto [scene, warnings] =
            import_mesh("v 0 0 0\nv 4 0 0\nv 4 4 1\nv 0 4 0\nf 1 2 3 4\n", "q.obj", from_the_front());
        CHECK(ids(scene) == std::vector<std::string>{"0.1", "0.2"});
        CHECK(warnings.front() == "q.obj: 1 face read, 0 dropped; 1 cut into convex polygons");
    }
    SUBCASE("an L of six corners: 2 parts that cover its area of 12 and no more") {
        const auto [scene, warnings] = import_mesh(
            "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 2 2 0\nv 2 4 0\nv 0 4 0\nf 1 2 3 4 5 6\n", "l.obj", from_the_front());
        CHECK(scene->polygons.size() == 2);
        CHECK(area_of(scene) == 12);  // 4 x 4 less 2 x 2, in whole pixels: exactly
    }
    SUBCASE("a square with a square hole, joined by a bridge: parts that cover its area of 36 - 4") {
        const auto [scene, warnings] = import_mesh(
            "v 0 0 0\nv 6 0 0\nv 6 6 0\nv 0 6 0\nv 2 2 0\nv 2 4 0\nv 4 4 0\nv 4 2 0\nf 1 2 3 4 1 5 6 7 8 5\n", "h.obj",
            from_the_front());
        CHECK(scene->polygons.size() <= 8);
        CHECK(area_of(scene) == 32);
    }
}

TEST_CASE("faces that cannot be shown are dropped and counted") {
    const std::string points = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 8 0 0\nv 100 0 0\nv 104 0 0\nv 100 4 0\n";
    const auto [scene, warnings] = import_mesh(points +
                                                   "f 1 2 3\n"    // 0: fine
                                                   "f 1 2\n"      // 1: two corners
                                                   "f 1 2 5\n"    // 2: in a line
                                                   "f 1 3 2 4\n"  // 3: a bow-tie
                                                   "f 6 7 8\n",   // 4: far to the right
                                               "d.obj", from_the_front());
    CHECK(ids(scene) == std::vector<std::string>{"0"});
    CHECK(warnings == std::vector<std::string>{
                          "d.obj: 5 faces read, 3 dropped: 2 without area, 1 crossing themselves; 1 not in view"});
}

TEST_CASE("files with false counts are refused before memory is reserved") {
    struct BadInput {
        std::string file, bytes, message;
    };
    const std::string billions = "4000000000";
    const std::string promise = " says 4000000000 ";
    const std::vector<BadInput> table{
        {"m.txt", "", "the name must end in that of a mesh: .obj, .off, .ply or .stl"},
        {"mesh", "", "the name must end in that of a mesh: .obj, .off, .ply or .stl"},
        {"m.obj", "", "contains no faces"},
        {"m.obj", "v 0 0 0\n", "contains no faces"},
        {"m.obj", "v 0 0\n", "line 1: not a number"},
        {"m.obj", "v 0 0 nan\n", "line 1: a coordinate that is not finite"},
        {"m.obj", "v 0 0 1e999\n", "line 1: a number beyond the range of doubles"},
        {"m.obj", "v 0 0 0\nf 1 1 2\n", "a face has vertex 2, of 1"},
        {"m.obj", "v 0 0 0\nf 0 1 1\n", "line 2: a face has a vertex that does not exist"},
        {"m.obj", "v 0 0 0\nf -2 1 1\n", "line 2: a face has a vertex that does not exist"},
        {"m.obj", "v 0 0 0\nf 1 1 99999999999999999999\n", "line 2: not a whole number"},
        {"m.obj", "v 0 0 0\nf 1 1 1\n", "no camera fits the mesh, which is a point or exceeds the range of doubles"},
        {"m.off", "", "empty"},
        {"m.off", "COF\n", "line 1: does not start with OFF"},
        {"m.off", "4OFF\n", "line 1: not of three dimensions"},
        {"m.off", "OFF BINARY\n", "line 1: binary OFF is not supported"},
        {"m.off", "OFF\n-8 6 0\n", "line 2: a negative count"},
        {"m.off", "OFF\n" + billions + " 1 0\n", "the header" + promise + "vertices, more than the file can hold"},
        {"m.off", "OFF\n1 " + billions + " 0\n0 0 0\n", "the header" + promise + "faces, more than the file can hold"},
        {"m.off", "OFF\n1 1 0\n0 0 0\n4000000000 0\n",
         "the header" + promise + "corners of a face, more than the file can hold"},
        {"m.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "line 4: a face has a vertex that does not exist"},
        {"m.off", "OFF\n1 1 0\n0 0 0\n", "line 3: the file ends before its last face"},
        {"m.ply", "", "does not start with ply"},
        {"m.ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "the file ends in its header"},
        {"m.ply", "ply\nformat ascii 1.0\nproperty float x\n", "line 3: a property before the first element"},
        {"m.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", "line 4: unknown type of a property"},
        {"m.ply", "ply\nformat EBCDIC 1.0\n", "line 2: unknown PLY format"},
        {"m.ply", "ply\nformat ascii 1.0\nelement dust " + billions + "\nend_header\n",
         "element dust has no properties"},
        {"m.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
         "element vertex has no number z"},
        {"m.ply", ply_header("ascii", billions),
         "the header" + promise + "items of element vertex, more than the file can hold"},
        {"m.ply", ply_header("binary_little_endian", billions),
         "the header" + promise + "items of element vertex, more than the file can hold"},
        {"m.ply", ply_header("binary_little_endian", "1", billions) + std::string(12, '\0'),
         "the header" + promise + "items of element face, more than the file can hold"},
        {"m.ply", ply_header("binary_little_endian", "1", "1") + std::string(12, '\0') + "\xff" + std::string(8, '\0'),
         "a list that is longer than the file, or of negative length"},
        {"m.ply", ply_header("ascii", "1", "1") + "0 0 0\n3 0 0 1\n", "a face has a vertex that does not exist"},
        {"m.ply", ply_header("ascii", "1", "1") + "0 0 0\n3 0 0 -1\n", "a face has a vertex that does not exist"},
        {"m.ply", ply_header("ascii", "1", "1") + "0 0 0\n3 0 0 0.5\n", "line 2: not a whole number"},
        {"m.ply",
         ply_header("binary_little_endian", "1", "0") + bytes_of(std::numeric_limits<float>::quiet_NaN()) +
             std::string(8, '\0'),
         "vertex 0: a coordinate that is not finite"},
        {"m.stl", "", "neither text that begins with solid nor long enough for a binary header"},
        {"m.stl", "facet", "neither text that begins with solid nor long enough for a binary header"},
        {"m.stl", std::string(80, ' ') + bytes_of(std::uint32_t(1000000)),
         "the header says 1000000 triangles, more than the file can hold"},
        {"m.stl", std::string(80, ' ') + bytes_of(std::uint32_t(4000000000)), "more than 1048576 faces"},
        {"m.stl", std::string(80, ' ') + bytes_of(std::uint32_t(0)), "contains no faces"},
        {"m.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n", "line 5: \"vertex\" is missing"},
        {"m.stl", "solid\n", "line 1: the file ends before endsolid"},
    };
    for (const auto& bad : table) {
        CAPTURE(bad.file);
        CAPTURE(bad.bytes);
        CHECK(message_for(bad.bytes, bad.file) == bad.file + ": " + bad.message);
    }
}

TEST_CASE("a truncated file is refused or read, and nothing worse happens") {
    const std::vector<std::pair<std::string, std::string>> files{
        {"c.obj", cube_obj()},       {"c.off", cube_off()},   {"c.ply", cube_ply()}, {"c.ply", binary_ply(false)},
        {"c.ply", binary_ply(true)}, {"c.stl", binary_stl()}, {"c.stl", text_stl()}};
    for (const auto& [file, bytes] : files) {
        for (std::size_t size = 0; size < bytes.size(); ++size) message_for(bytes.substr(0, size), file);
    }
    for (std::size_t size = 0; size + 1 < binary_ply(false).size(); ++size) {
        REQUIRE(message_for(binary_ply(false).substr(0, size), "c.ply") != "taken");
    }
}

TEST_CASE("sizes and cameras that make no picture are refused") {
    ImportOptions options;
    options.width = 0;
    CHECK_THROWS_WITH_AS(import_mesh(cube_obj(), "c.obj", options),
                         "c.obj: the size is not from 1 to 16384 pixels a side", Refused);
    options = from_the_front();
    options.camera->target = options.camera->eye;
    CHECK_THROWS_WITH_AS(import_mesh(cube_obj(), "c.obj", options), "c.obj: camera: eye and target are one point",
                         Refused);
}
