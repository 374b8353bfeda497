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

std::string cube_obj() { return "# a cube\n" + text_points("v ") + text_faces("f", 1); }
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

std::vector<std::string> reported(const std::vector<Loss>& losses) {
    std::vector<std::string> out;
    for (const auto& [what, where] : losses) out.push_back(where + ": " + what);
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
    const auto [scene, report, losses] = import_mesh(cube_obj(), "models/cube.obj", {});
    CHECK(report == "models/cube.obj: 6 faces read, 0 dropped");
    CHECK(losses.empty());
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

/// A mesh of one triangle, (0,0) (4,0) (0,3), as people's programs write it.
struct Brought {
    std::string name, file, bytes;
};

TEST_CASE("the triangle (0,0) (4,0) (0,3), in whatever layout it comes") {
    const std::string points = "v 0 0 0\nv 4 0 0\nv 0 3 0\n", face = "f 1 2 3\n";
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nelement face 1\n";
    const std::string list = "property list uchar int vertex_indices\nend_header\n";
    const std::string facet =
        "facet normal nan -nan(ind) inf\nouter loop\nvertex 0 0 0\nvertex 4 0 0\nvertex 0 3 0\n"
        "end loop\nend facet\n";
    std::string solid = "solid of a program that pads with blanks";
    solid.resize(80, ' ');
    solid +=
        bytes_of(std::uint32_t(1)) + bytes_of(std::numeric_limits<float>::quiet_NaN()) + bytes_of(0.F) + bytes_of(1.F);
    for (const float value : {0.F, 0.F, 0.F, 4.F, 0.F, 0.F, 0.F, 3.F, 0.F}) solid += bytes_of(value);
    solid += std::string(2, '\0');
    const std::vector<Brought> table{
        // A backslash that ends no statement of numbers belongs to what it stands in.
        {"comment", "t.obj", "# saved in D:\\models\\\n" + points + "v 9 9 9\n" + face},
        {"comment after a vertex", "t.obj", "v 0 0 0 # D:\\\nv 4 0 0\nv 0 3 0\nf 1 2 3 # \\\n"},
        {"group", "t.obj", "g D:\\models\\\n" + points + face},
        {"object", "t.obj", "o D:\\models\\\r\n" + points + face},
        {"material", "t.obj", points + "usemtl D:\\models\\\n" + face},
        {"library", "t.obj", "mtllib D:\\models\\\n" + points + face},
        {"smoothing", "t.obj", "s D:\\\n" + points + face},
        {"no statement", "t.obj", "saved D:\\\n" + points + face},
        {"continued", "t.obj", "v 0 \\\n0 0\nv 4\\\r\n0 0\nv 0 3 \\\r0\nf 1 2\\\n3"},
        // Marks and ends of lines.
        {"mark in OBJ", "t.obj", "\xef\xbb\xbf" + points + face},
        {"mark in OFF", "t.off", "\xef\xbb\xbfOFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"},
        {"mark in PLY", "t.ply", "\xef\xbb\xbf" + ply + list + "0 0 0 0\n4 0 0 0\n0 3 0 0\n3 0 1 2\n"},
        {"mark in STL", "t.stl", "\xef\xbb\xbfsolid\n" + facet + "endsolid\n"},
        {"CR in OBJ", "t.obj", "# a\rv 0 0 0\rv 4 0 0\rv 0 3 0\rf 1 2 3\r"},
        {"CR in OFF", "t.off", "OFF\r3 1 0\r0 0 0\r4 0 0\r0 3 0\r3 0 1 2\r"},
        // The free layout of OFF.
        {"two vertices in a line", "t.off", "OFF\n3 1 0\n0 0 0 4 0 0\n0 3 0\n3 0 1 2\n"},
        {"a vertex in two lines", "t.off", "OFF\n3 1 0\n0 0\n0\n4 0 0\n0 3 0\n3 0 1 2\n"},
        {"a face in two lines", "t.off", "OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0\n1 2\n"},
        {"counts that adjoin", "t.off", "OFF3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"},
        {"no keyword", "t.off", "3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"},
        {"the first vertex in the line of the counts", "t.off", "OFF 3 1 0 0 0 0\n4 0 0\n0 3 0\n3 0\n1 2\n"},
        {"all in one line", "t.off", "OFF 3 1 0 0 0 0 4 0 0 0 3 0 3 0 1 2"},
        {"no count of edges", "t.off", "OFF\n3 1\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n"},
        {"comments anywhere", "t.off", "# a\nOFF # b\n3 # c\n1 0\n0 0 # d\n0\n4 0 0\n#\n0 3 0\n3 0 1 # e\n2\n"},
        {"normals and texture", "t.off",
         "STNOFF\n3 1 0\n0 0 0 nan 0 1 0 0\n4 0 0 0 0 1 1 0\n0 3 0 0 0 1 0 1\n3 0 1 2\n"},
        // PLY: what is no coordinate may be anything; a list of any name; strips.
        {"normals that are not finite", "t.ply", ply + list + "0 0 0 nan\n4 0 0 inf\n0 3 0 -1.#IND\n3 0 1 2\n"},
        {"free layout", "t.ply", ply + list + "0 0\n0 0 4 0 0 0\n0 3 0 0 3 0\n1 2\n"},
        {"another name", "t.ply",
         ply + "property list uchar uint corners\nend_header\n0 0 0 0\n4 0 0 0\n0 3 0 0\n3 0 1 2\n"},
        {"strips", "t.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n4 0 0\n0 3 0\n4 0 1 2 -1\n"},
        // STL.
        {"end solid", "t.stl", "solid a\n" + facet + "end solid a\n"},
        {"capitals", "t.stl",
         "SOLID a\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 4 0 0\nVERTEX 0 3 0\n"
         "ENDLOOP\nENDFACET\nENDSOLID\n"},
        {"binary that begins with solid", "t.stl", solid},
        {"the same and more bytes after it", "t.stl", solid + "made by a program"},
    };
    for (const Brought& brought : table) {
        CAPTURE(brought.name);
        const MeshSoup soup = read_mesh_soup(brought.bytes, brought.file, {});
        REQUIRE(soup.faces.size() == 1);
        std::vector<glm::dvec3> corners;
        for (const std::size_t i : soup.faces[0].corners) corners.push_back(soup.points[i]);
        CHECK(corners == std::vector<glm::dvec3>{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}});
    }
}

TEST_CASE("a strip of PLY turns every second triangle, and a repeated corner joins two strips") {
    // 0 1 2 3: the triangles 0 1 2 and 2 1 3. 3 3 1: the places 1 2 3 3, 2 3 3 1 have a corner twice.
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n4 0 0\n0 3 0\n4 3 0\n8 0 1 2 3 3 -1 1 0\n";
    const MeshSoup soup = read_mesh_soup(text, "s.ply", {});
    REQUIRE(soup.faces.size() == 2);
    CHECK(soup.faces[0].corners == std::vector<std::size_t>{0, 1, 2});
    CHECK(soup.faces[1].corners == std::vector<std::size_t>{2, 1, 3});
}

TEST_CASE("a binary PLY after a header of lines that end in CR: its first byte may be LF") {
    std::string text = ply_header("binary_little_endian", "3", "1");
    std::replace(text.begin(), text.end(), '\n', '\r');
    const auto ten = std::bit_cast<float>(0x4120000A);  // a little more than 10; its first byte is 0A
    for (const float value : {ten, 0.F, 0.F, 4.F, 0.F, 0.F, 0.F, 3.F, 0.F}) text += bytes_of(value);
    text += '\3' + bytes_of(std::int32_t(0)) + bytes_of(std::int32_t(1)) + bytes_of(std::int32_t(2));
    CHECK(read_mesh_soup(text, "b.ply", {}).points.front().x == double(ten));
}

TEST_CASE("colours of materials, vertices and faces come into the scene") {
    const std::string points = "v 0 0 0\nv 4 0 0\nv 0 3 0\n", red = "v 0 0 0 1 0 0\nv 4 0 0 1 0 0\nv 0 3 0 1 0 0\n";
    const std::string library = "newmtl a\nKd 1 0 0\nnewmtl b#1 x\nKd 0.2 0.4 0.6\nnewmtl grey\nKd 0.4 # all three\n";
    const Beside beside = [&](const std::string& name) {
        return name == "my paints.mtl" ? std::optional(library) : std::nullopt;
    };
    const std::string use = "mtllib my paints.mtl\n" + points + "usemtl ";
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string parts = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const std::string list = "property list uchar int vertex_indices\n", end = "end_header\n";
    struct Colored {
        std::string file, bytes;
        Color color;
    };
    const std::vector<Colored> table{
        {"t.obj", use + "a\nf 1 2 3\n", {255, 0, 0}},
        {"t.obj", use + "b#1 x # the second\nf 1 2 3\n", {51, 102, 153}},  // 255 times 0.2, 0.4, 0.6
        {"t.obj", use + "grey\nf 1 2 3\n", {102, 102, 102}},
        {"t.obj", red + "f 1 2 3\n", {255, 0, 0}},
        {"t.obj", "v 0 0 0 0 51 255\nv 4 0 0 0 51 255\nv 0 3 0 0 51 255\nf 1 2 3\n", {0, 51, 255}},
        {"t.off", "OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2 51 102 153\n", {51, 102, 153}},
        {"t.off", "OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2 0.2 0.4 0.6 1\n", {51, 102, 153}},
        {"t.off",
         "COFF\n3 1 0\n0 0 0 51 102 153 255\n4 0 0 51 102 153 255\n0 3 0 51 102 153 255\n3 0 1 2\n",
         {51, 102, 153}},
        {"t.off", "COFF\n3 1 0\n0 0 0 1 0 0\n4 0 0 1 0 0\n0 3 0 1 0 0\n3 0 1 2\n", {255, 0, 0}},
        {"t.off",
         "CNOFF\n3 1 0\n0 0 0 0 0 1 0 9 0 255\n4 0 0 0 0 1 0 9 0 255\n0 3 0 0 0 1 0 9 0 255\n3 0 1 2\n",
         {0, 9, 0}},
        {"t.ply",
         ply + parts + "element face 1\n" + list + end + "0 0 0 9 8 7\n4 0 0 9 8 7\n0 3 0 9 8 7\n3 0 1 2\n",
         {9, 8, 7}},
        {"t.ply", ply + "element face 1\n" + list + parts + end + "0 0 0\n4 0 0\n0 3 0\n3 0 1 2 9 8 7\n", {9, 8, 7}},
        {"t.ply",
         ply + "element face 1\n" + list + "property float red\nproperty float green\nproperty float blue\n" + end +
             "0 0 0\n4 0 0\n0 3 0\n3 0 1 2 0.2 0.4 0.6\n",
         {51, 102, 153}},
    };
    for (const auto& [file, bytes, color] : table) {
        const auto& shown_bytes = bytes;
        CAPTURE(shown_bytes);
        const auto [scene, report, losses] = import_mesh(bytes, file, from_the_front(), beside);
        REQUIRE(scene->polygons.size() == 1);
        CHECK(scene->polygons[0].color == color);
        CHECK(reported(losses).empty());
    }
}

TEST_CASE("import names what a scene cannot keep, with its line") {
    const std::string points = "v 0 0 0\nv 4 0 0\nv 0 3 0\n", face = "f 1 2 3\n",
                      off = "OFF\n3 1 0\n0 0 0\n4 0 0\n0 3 0\n";
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\n";
    std::string attributes = binary_stl();
    attributes.back() = '\1';  // of the last triangle, 11
    const Beside beside = [](const std::string& name) {
        return name == "a.mtl"
                   ? std::optional<std::string>("newmtl glass\nKd 1 1 1\nd 0.5\nmap_Kd wood.png\nnewmtl bare\n")
                   : std::nullopt;
    };
    struct Losing {
        std::string file, bytes;
        std::vector<std::string> reported;
    };
    const std::vector<Losing> table{
        {"t.obj", points + "l 1 2\np 1\n" + face, {"line 4: left out: lines and points (2 times, here first)"}},
        {"t.obj",
         "mtllib b.mtl\n" + points + "usemtl x\n" + face,
         {"line 1: left out: colours: the library of materials \"b.mtl\" cannot be read"}},
        {"t.obj", points + "usemtl x\n" + face, {"line 4: left out: colours: no library has the material \"x\""}},
        {"t.obj",
         "mtllib a.mtl\n" + points + "usemtl glass\n" + face,
         {"line 5: left out: textures", "line 5: left out: transparency"}},
        {"t.obj",
         "mtllib a.mtl\n" + points + "usemtl bare\n" + face,
         {"line 5: left out: colours: the material \"bare\" has no Kd of red, green and blue"}},
        {"t.obj",
         "v 0 0 0 1 0 0\nv 4 0 0 1 0 0\nv 0 3 0 0 0 0\n" + face,
         {"line 4: left out: a change of colour within a face, which has the mean"}},
        {"t.obj", "v 0 0 0 2\nv 4 0 0\nv 0 3 0\n" + face, {"line 1: left out: weights of vertices"}},
        {"t.obj", points + "curv 0 1 1 2 \\\n3\n" + face, {"line 4: left out: curves and curved surfaces"}},
        {"t.obj", points + "face 1 2 3\n" + face, {"line 4: left out: statements that are not of OBJ, \"face\""}},
        {"t.off", off + "3 0 1 2 0\n", {"line 6: left out: a colour that is a place in a table of colours"}},
        {"t.off", off + "3 0 1 2 255 0 0 9\n", {"line 6: left out: transparency"}},
        {"t.off", off + "3 0 1 2\n0 1\n", {"line 7: left out: text after the last face"}},
        {"t.off",
         "OFF\n3 1 0\n0 0 0 9\n4 0 0 9\n0 3 0 9\n3 0 1 2\n",
         {"line 3: left out: numbers of vertices that the header does not announce (3 times, here first)"}},
        {"t.ply",
         ply + "element edge 1\nproperty int vertex1\nend_header\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n0\n",
         {"line 16: left out: element edge"}},
        {"t.ply",
         ply + "comment TextureFile wood.png\nend_header\n0 0 0\n4 0 0\n0 3 0\n3 0 1 2\n",
         {"line 9: left out: textures"}},
        {"t.stl", attributes, {"face 11: left out: attributes of triangles, which may be colours"}},
    };
    for (const auto& [file, bytes, lost] : table) {
        const auto& shown_bytes = bytes;
        CAPTURE(shown_bytes);
        CHECK(reported(import_mesh(bytes, file, from_the_front(), beside).losses) == lost);
    }
}

TEST_CASE("a face bears the name of its group or object") {
    const std::string text = "v 0 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3\no left wing\nf 1 2 3\ng\nf 1 2 3\ng \xff\nf 1 2 3\n";
    CHECK(ids(import_mesh(text, "g.obj", from_the_front()).scene) ==
          std::vector<std::string>{"0", "left wing:1", "2", "\xef\xbf\xbd:3"});
}

TEST_CASE("an error names its line") {
    const std::string ply =
        "ply\nformat ascii 1.0\ncomment a\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::vector<Brought> table{
        {"line 7: not a number: x", "t.obj", "# a\\\n\nv 0 \\\n 0 \\\n 0\n\nv x 0 0\n"},
        {"line 5: not a number: x", "t.obj", "v 0 \\\n 0 \\\n 0\nv 0 \\\n x 0\n"},
        {"line 3: not a number: x", "t.obj", "v 0 0 0\rv 1 0 0\rv x 0 0\r"},
        {"line 2: not a number: 1,5", "t.obj", "v 0 0 0\r\nv 1,5 0 0\r\n"},
        {"line 4: a face has a vertex that does not exist, of 3", "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"},
        {"line 13: not a number: x", "t.ply", ply + "0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"},
        {"line 12: a number is missing", "t.ply", ply + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"},
        {"line 12: more numbers than properties", "t.ply", ply + "0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n"},
        {"line 12: a coordinate that is not finite", "t.ply", ply + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"},
        {"line 14: a face has a vertex that does not exist, of 3", "t.ply", ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"},
        {"line 4: not a number: x", "t.off", "OFF # a\n\n3 1 0\n0 x 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"line 4: a number is missing", "t.off", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"},
        {"line 6: not a number: x", "t.stl", "solid\n\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 x 0\n"},
        {"line 2: contains no faces, for no solid has a facet", "t.stl", "solid a\nendsolid a\n"},
        {"contains no faces, only 1 vertex; line 2: left out: lines and points", "t.obj", "v 0 0 0\np 1\n"},
    };
    for (const auto& [message, file, bytes] : table) {
        const auto& shown_bytes = bytes;
        CAPTURE(shown_bytes);
        CHECK(message_for(bytes, file) == file + ": " + message);
    }
}

TEST_CASE("text in UTF-16 or UTF-32 is refused by that name, whatever the format") {
    for (const std::string file : {"t.obj", "t.off", "t.ply", "t.stl"}) {
        for (const bool has_mark : {true, false}) {
            for (const bool big_endian : {true, false}) {
                std::string two, four;
                for (const char32_t c : std::u32string(has_mark ? U"\ufeff" : U"") + U"OFF\nply\nv 0 0 0") {
                    two += bytes_of(std::uint16_t(c), big_endian);
                    four += bytes_of(std::uint32_t(c), big_endian);
                }
                CHECK(message_for(two, file) == file + ": text in UTF-16; save it as UTF-8");
                CHECK(message_for(four, file) == file + ": text in UTF-32; save it as UTF-8");
            }
        }
    }
}

TEST_CASE("a number too small for a double is 0, one too great is refused") {
    CHECK(read_mesh_soup("v 1e-999 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3\n", "t.obj", {}).points[0] == glm::dvec3(0));
    CHECK(message_for("v 0 0 -1e999\n", "t.obj") == "t.obj: line 1: a number beyond the range of doubles");
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
        const auto [scene, report, losses] =
            import_mesh("v 0 0 0\nv 4 0 0\nv 4 4 1\nv 0 4 0\nf 1 2 3 4\n", "q.obj", from_the_front());
        CHECK(ids(scene) == std::vector<std::string>{"0.1", "0.2"});
        CHECK(report == "q.obj: 1 face read, 0 dropped; 1 cut into convex polygons");
    }
    SUBCASE("an L of six corners: 2 parts that cover its area of 12 and no more") {
        const auto [scene, report, losses] = import_mesh(
            "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 2 2 0\nv 2 4 0\nv 0 4 0\nf 1 2 3 4 5 6\n", "l.obj", from_the_front());
        CHECK(scene->polygons.size() == 2);
        CHECK(area_of(scene) == 12);  // 4 x 4 less 2 x 2, in whole pixels: exactly
    }
    SUBCASE("a square with a square hole, joined by a bridge: parts that cover its area of 36 - 4") {
        const auto [scene, report, losses] = import_mesh(
            "v 0 0 0\nv 6 0 0\nv 6 6 0\nv 0 6 0\nv 2 2 0\nv 2 4 0\nv 4 4 0\nv 4 2 0\nf 1 2 3 4 1 5 6 7 8 5\n", "h.obj",
            from_the_front());
        CHECK(scene->polygons.size() <= 8);
        CHECK(area_of(scene) == doctest::Approx(32));
    }
}

TEST_CASE("faces that cannot be shown are dropped and counted") {
    const std::string points = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 8 0 0\nv 100 0 0\nv 104 0 0\nv 100 4 0\n";
    const auto [scene, report, losses] = import_mesh(points +
                                                         "f 1 2 3\n"    // 0: fine
                                                         "f 1 2\n"      // 1: two corners
                                                         "f 1 2 5\n"    // 2: in a line
                                                         "f 1 3 2 4\n"  // 3: a bow-tie
                                                         "f 6 7 8\n",   // 4: far to the right
                                                     "d.obj", from_the_front());
    CHECK(ids(scene) == std::vector<std::string>{"0"});
    CHECK(report == "d.obj: 5 faces read, 3 dropped: 2 without area, 1 crossing themselves; 1 not in view");
    CHECK(reported(losses) == std::vector<std::string>{"line 10: left out: faces without area (2 times, here first)",
                                                       "line 12: left out: faces that cross themselves"});
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
        {"m.obj", "", "contains no faces, only 0 vertices"},
        {"m.obj", "v 0 0 0\n", "contains no faces, only 1 vertex"},
        {"m.obj", "v 0 0\n", "line 1: a number is missing"},
        {"m.obj", "v 0 0 nan\n", "line 1: a coordinate that is not finite"},
        {"m.obj", "v 0 0 1e999\n", "line 1: a number beyond the range of doubles"},
        {"m.obj", "v 0 0 0\nf 1 1 2\n", "line 2: a face has a vertex that does not exist, of 1"},
        {"m.obj", "v 0 0 0\nf 0 1 1\n", "line 2: a face has a vertex that does not exist"},
        {"m.obj", "v 0 0 0\nf -2 1 1\n", "line 2: a face has a vertex that does not exist"},
        {"m.obj", "v 0 0 0\nf 1 1 99999999999999999999\n", "line 2: not a whole number: 99999999999999999999"},
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
        {"m.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "line 4: a face has a vertex that does not exist, of 1"},
        {"m.off", "OFF\n1 1 0\n0 0 0\n", "line 3: the file ends before its last face"},
        {"m.ply", "", "does not start with ply"},
        {"m.ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "the file ends in its header"},
        {"m.ply", "ply\nformat ascii 1.0\nproperty float x\n", "line 3: a property before the first element"},
        {"m.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n",
         "line 4: unknown type of a property: quad"},
        {"m.ply", "ply\nformat EBCDIC 1.0\n", "line 2: unknown PLY format: EBCDIC"},
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
         "face 0: a list that is longer than the file, or of negative length"},
        {"m.ply", ply_header("ascii", "1", "1") + "0 0 0\n3 0 0 1\n",
         "line 12: a face has a vertex that does not exist, of 1"},
        {"m.ply", ply_header("ascii", "1", "1") + "0 0 0\n3 0 0 -1\n",
         "line 12: a face has a vertex that does not exist"},
        {"m.ply", ply_header("ascii", "1", "1") + "0 0 0\n3 0 0 0.5\n", "line 12: not a whole number"},
        {"m.ply",
         ply_header("binary_little_endian", "1", "0") + bytes_of(std::numeric_limits<float>::quiet_NaN()) +
             std::string(8, '\0'),
         "vertex 0: a coordinate that is not finite"},
        {"m.stl", "", "neither text that begins with solid nor long enough for a binary header"},
        {"m.stl", "facet", "neither text that begins with solid nor long enough for a binary header"},
        {"m.stl", std::string(80, ' ') + bytes_of(std::uint32_t(1000000)),
         "the header says 1000000 triangles, more than the file can hold"},
        {"m.stl", std::string(80, ' ') + bytes_of(std::uint32_t(4000000000)), "more than 1048576 faces"},
        {"m.stl", std::string(80, ' ') + bytes_of(std::uint32_t(0)), "contains no faces: the header says 0 triangles"},
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

TEST_CASE("faces in one plane that share edges are parts of one face, of one colour") {
    // A square of two triangles, a third one of the same plane beside it, and one that is bent away from it.
    const AdmittedScene scene =
        import_mesh("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 8 0 0\nv 0 0 -3\nf 1 2 3\nf 1 3 4\nf 2 5 3\nf 1 6 2\n",
                    "s.obj", from_the_front())
            .scene;
    const auto face_of = [&](const std::string& id) {
        for (const auto& polygon : scene->polygons) {
            if (polygon.id == id) return polygon.face;
        }
        return std::string("not in view");
    };
    CHECK(face_of("0") == "0");
    CHECK(face_of("1") == "0");
    CHECK(face_of("2") == "0");
    CHECK(scene->polygons[0].color == scene->polygons[1].color);
    CHECK(face_of("3") != "0");
}

TEST_CASE("faces of two colours, of two groups, and those that only touch are no parts of one face") {
    for (const std::string mesh : {
             "v 0 0 0 1 0 0\nv 4 0 0 1 0 0\nv 4 4 0 1 0 0\nv 0 0 0 0 0 1\nv 4 4 0 0 0 1\nv 0 4 0 0 0 1\nf 1 2 3\nf 4 5 "
             "6\n",
             "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\ng a\nf 1 2 3\ng b\nf 1 3 4\n",
             "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv -4 0 0\nf 1 2 3\nf 1 4 5\n",
         }) {
        CAPTURE(mesh);
        const auto [scene, report, losses] = import_mesh(mesh, "s.obj", from_the_front());
        REQUIRE(scene->polygons.size() == 2);
        CHECK(scene->polygons[0].face.empty());
        CHECK(scene->polygons[1].face.empty());
    }
}
