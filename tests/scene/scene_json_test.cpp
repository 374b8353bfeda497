/// Scene files: accepted ones, and a table of refused ones with the place and the reason.
#include "scene/scene_json.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "json/document_format.h"
#include "refused.h"
#include "support/places.h"
#include "support/scenes.h"

namespace {

using namespace vidno;
using test::without_places;

constexpr auto triangle = R"({"color": "#102030", "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]})";

/// A scene of 16 x 16 with these polygons and, if given, more keys.
std::string scene_with(const std::string& polygons, const std::string& more = "") {
    return R"({"format": "vidno-scene/1", "window": {"x": 0, "y": 0, "width": 16, "height": 16}, )" + more +
           R"("polygons": [)" + polygons + "]}";
}

std::string polygon_with(const std::string& vertices) {
    return R"({"color": "#102030", "vertices": )" + vertices + "}";
}

std::string scene_with_window(const std::string& window) {
    return R"({"format": "vidno-scene/1", "window": )" + window + R"(, "polygons": []})";
}

std::string scene_with_camera(const std::string& camera) {
    return scene_with(triangle, R"("camera": )" + camera + ", ");
}

std::string message_for(const std::string& text) {
    try {
        read_scene(text, "f.json");
        return "taken";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

struct BadInput {
    std::string text, message;
};

/// The messages have the paths in the document; the places in the text are tested separately.
void check_refused(const std::vector<BadInput>& table) {
    for (const BadInput& bad : table) {
        CAPTURE(bad.text);
        CHECK(without_places(message_for(bad.text)) == "f.json: " + bad.message);
    }
}

}  // namespace

TEST_CASE("a scene is read and written in one form") {
    const auto [scene, warnings] = read_scene(R"({
        "polygons": [{"vertices": [[-0.0, 1e300, 1], ["0x1.8p-3", "-0x1p4", -1], [3, 2.50, 0.1]], "color": "#1F77b4"},
                     {"id": "B \"2\"", "color": "#000000", "vertices": [[0, 0, 0], [1, 0, 0], [2, 0, 0]]}],
        "window": {"x": -2, "y": 3, "width": 16.0, "height": 8},
        "format": "vidno-scene/1"})",
                                              "f.json");
    CHECK(warnings.empty());
    CHECK(scene->area == Area{-2, 3, 16, 8});
    CHECK(scene->background == Color{255, 255, 255});
    REQUIRE(scene->polygons.size() == 2);
    CHECK(scene->polygons[0].id == "0");
    CHECK_FALSE(scene->polygons[0].edge_on);
    CHECK(scene->polygons[0].vertices[1] == glm::dvec3(0.1875, -16, -1));  // 1.5 / 8 and -1 x 16
    CHECK(scene->polygons[1].id == "B \"2\"");
    CHECK(scene->polygons[1].edge_on);

    const std::string text = scene_json(scene);
    CHECK(text ==
          R"({"format":"vidno-scene/1","name":"","window":{"x":-2,"y":3,"width":16,"height":8},"background":"#ffffff",)"
          R"("polygons":[{"id":"0","color":"#1f77b4","vertices":[[0,1e+300,1],[0.1875,-16,-1],[3,2.5,0.1]]},)"
          R"({"id":"B \"2\"","color":"#000000","vertices":[[0,0,0],[1,0,0],[2,0,0]]}]})");
    const auto again = read_scene(text, "again.json");
    CHECK(again.scene == scene);
    CHECK(scene_json(again.scene) == text);
}

TEST_CASE("a vertex reflex by rounding is dropped with a warning") {
    const auto [scene, warnings] =
        read_scene(scene_with(std::string(triangle) + ", " +
                              polygon_with("[[0, 0, 0], [4, 1e-13, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0]]")),
                   "f.json");
    CHECK(scene->polygons[1].vertices.size() == 4);
    CHECK(warnings == std::vector<std::string>{"f.json: /polygons/1: 1 vertex reflex by rounding, dropped"});
}

TEST_CASE("a camera takes the scene to the screen") {
    // Orthographic, 16 high on 16 pixels: x' = 8 + x, y' = 8 - y; z from 1 at distance 0 to -1 at distance 10.
    const auto [scene, warnings] = read_scene(
        scene_with(polygon_with("[[-4, -4, 0], [4, -4, 0], [-4, 4, 0]]") + ", " +
                       polygon_with("[[100, 0, 0], [101, 0, 0], [100, 1, 0]]") + ", " +
                       polygon_with("[[0, 0, 0], [1, 1, 1], [2, 2, 2]]"),
                   R"("camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "projection": "orthographic", "height": 16,
                                 "near": 0, "far": 10}, )"),
        "f.json");
    REQUIRE(scene->polygons.size() == 1);
    CHECK(scene->polygons[0].vertices == std::vector<glm::dvec3>{{4, 12, 0}, {12, 12, 0}, {4, 4, 0}});
    CHECK(warnings == std::vector<std::string>{"f.json: /polygons/1: not in view, left out",
                                               "f.json: /polygons/2: no area, left out"});
}

TEST_CASE("text that is not JSON is refused with its line and column") {
    check_refused({
        {"", "line 1, column 1: not valid JSON"},
        {"{\n  \"format\": ?", "line 2, column 13: not valid JSON"},
        {"[1, 2", "line 1, column 6: not valid JSON"},
        {"{} {}", "line 1, column 4: not valid JSON"},
        {"{\"name\": \"\xff\"}", "line 1, column 11: not valid JSON"},
        {std::string(100000, '['), "/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0/0: nested too deeply"},
        {R"({"name": "a", "name": "b"})", "/name: the key occurs twice"},
        {scene_with(R"({"color": "#000000", "color": "#000000"})"), "/polygons/0/color: the key occurs twice"},
        {scene_with(polygon_with("[[0, 0, 0], [1, 1e999, 0]]")),
         "/polygons/0/vertices/1/1: the number is beyond the range of doubles"},
    });
}

TEST_CASE("keys and types are strict") {
    const std::string a_scene = scene_with(triangle);
    check_refused({
        {"[]", "not an object"},
        {"{}", "\"polygons\" is missing"},
        {R"({"format": "vidno-scene/2", "polygons": [)" + std::string(triangle) + "]}",
         "/format: not \"vidno-scene/1\" but \"vidno-scene/2\": a newer vidno reads this file"},
        {R"({"format": "vidno-scene/0", "polygons": [)" + std::string(triangle) + "]}",
         "/format: not \"vidno-scene/1\" but \"vidno-scene/0\": an older vidno reads this file"},
        {R"({"format": "picture/2", "polygons": [)" + std::string(triangle) + "]}", "/format: not \"vidno-scene/1\""},
        {R"({"format": 1, "polygons": [)" + std::string(triangle) + "]}", "/format: not a string"},
        {scene_with(triangle, R"("light": 1, )"), "/light: unknown key"},
        {scene_with(triangle, R"("a/b~c": 1, )"), "/a~1b~0c: unknown key"},
        {scene_with(triangle, R"("name": 7, )"), "/name: not a string"},
        {scene_with(triangle, R"("background": "white", )"), "/background: not a colour of the form \"#rrggbb\""},
        {scene_with(triangle, R"("background": "#fffffg", )"), "/background: not a colour of the form \"#rrggbb\""},
        {scene_with("7"), "/polygons/0: not an object"},
        {scene_with(R"({"color": "#000000"})"), "/polygons/0: \"vertices\" is missing"},
        {scene_with(R"({"color": 7, "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]})"),
         "/polygons/0/color: not a string"},
        {scene_with(polygon_with("{}")), "/polygons/0/vertices: not an array"},
        {scene_with(polygon_with("[[0, 0]]")), "/polygons/0/vertices/0: not three coordinates"},
        {scene_with(polygon_with("[[0, 0, 0, 0]]")), "/polygons/0/vertices/0: not three coordinates"},
    });
}

TEST_CASE("the window is whole pixels within bounds") {
    check_refused({
        {scene_with_window("[]"), "/window: not an object"},
        {scene_with_window(R"({"x": 0, "y": 0, "width": 16})"), "/window: \"height\" is missing"},
        {scene_with_window(R"({"x": 0.5, "y": 0, "width": 16, "height": 16})"), "/window/x: not a whole number"},
        {scene_with_window(R"({"x": "0", "y": 0, "width": 16, "height": 16})"), "/window/x: not a whole number"},
        {scene_with_window(R"({"x": 0, "y": 0, "width": 0, "height": 16})"), "/window/width: not from 1 to 16384"},
        {scene_with_window(R"({"x": 0, "y": 0, "width": 16, "height": 16385})"), "/window/height: not from 1 to 16384"},
        {scene_with_window(R"({"x": 0, "y": 1073741825, "width": 16, "height": 16})"),
         "/window/y: not from -1073741824 to 1073741824"},
    });
    CHECK(message_for(scene_with_window(R"({"x": -1073741824, "y": 1073741824, "width": 16384, "height": 1})")) ==
          "taken");
}

TEST_CASE("coordinates are numbers or hexadecimal text") {
    const auto scene_with_x = [](const std::string& x) {
        return scene_with(polygon_with("[[" + x + ", 0, 0], [99, 0, 0], [0, 99, 0]]"));
    };
    for (const std::string good : {R"("0x1p0")", R"("0X1.fP+3")", R"("-0x.8p0")", R"("0x0.0000000000001p-1022")"}) {
        CAPTURE(good);
        const bool taken = message_for(scene_with_x(good)) == "taken";
        CHECK(taken == (good.find("0x.") == std::string::npos));
    }
    const std::string place = "/polygons/0/vertices/0/0: ";
    for (const std::string bad :
         {R"("")", R"("1.5")", R"("0x")", R"("0x1")", R"("0x1.8")", R"("0x1p")", R"("0x1p1 ")", R"(" 0x1p1")",
          R"("+0x1p1")", R"("--0x1p1")", R"("0x-1p1")", R"("0xinfp1")", R"("0x1.8.p1")", R"("nan")", R"("0xp1")"}) {
        CAPTURE(bad);
        CHECK(without_places(message_for(scene_with_x(bad))) ==
              "f.json: " + place + "not a hexadecimal number such as \"0x1.8p-3\"");
    }
    check_refused({
        {scene_with_x(R"("0x1p1024")"), place + "the number is beyond the range of doubles"},
        {scene_with_x("null"), place + "neither a number nor a hexadecimal one as text, such as \"0x1.8p-3\""},
        {scene_with_x("[1]"), place + "neither a number nor a hexadecimal one as text, such as \"0x1.8p-3\""},
    });
}

TEST_CASE("polygons are checked exactly, and ids are unique") {
    const std::string named = R"({"id": "A", "color": "#102030", "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]})";
    const auto scene_with_id = [](const std::string& id) {
        return scene_with(R"({"id": ")" + id + R"(", "color": "#102030", "vertices": []})");
    };
    check_refused({
        {scene_with(polygon_with("[]")), "/polygons/0/vertices: fewer than three vertices"},
        {scene_with(polygon_with("[[0, 0, 0], [4, 0, 1.5], [0, 4, 0]]")),
         "/polygons/0/vertices/1/2: z outside -1 to 1"},
        {scene_with(std::string(triangle) + ", " + polygon_with("[[0, 0, 0], [4, 0, 0], [4, 4, 1], [0, 4, 0]]")),
         "/polygons/1/vertices/3: not planar: in the plane of [0,0,0], [4,0,0] and [4,4,1] this vertex would have z = "
         "1; "
         "triangles are always planar"},
        {scene_with(polygon_with("[[0, 3, 0], [2, -3, 0], [-3, 1, 0], [3, 1, 0], [-2, -3, 0]]")),
         "/polygons/0/vertices/2: not convex, and the edges from [0,3,0] and [-3,1,0] cross; cut the polygon there"},
        {scene_with(named + ", " + named), "/polygons/1/id: the id occurs twice"},
        {scene_with(R"({"id": "1", "color": "#102030", "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]}, )" +
                    std::string(triangle)),
         "/polygons/1: the id occurs twice; a polygon without an id gets its position"},
        {scene_with_id(""), "/polygons/0/id: empty"},
        {scene_with_id(std::string(201, 'x')), "/polygons/0/id: longer than 200 bytes"},
    });
}

TEST_CASE("a camera is complete and sees something") {
    check_refused({
        {scene_with_camera("{}"),
         "/camera: \"eye\" is missing\nf.json: /camera: \"target\" is missing\nf.json: /camera: \"projection\" is "
         "missing\nf.json: /camera: \"fov\" is missing\nf.json: /camera: \"near\" is missing\nf.json: /camera: "
         "\"far\" is missing"},
        {scene_with_camera(R"({"target": [0, 0, 0], "projection": "perspective", "fov": 45, "near": 1, "far": 9})"),
         "/camera: \"eye\" is missing"},
        {scene_with_camera(R"({"eye": [0, 0, 5], "target": [0, 0, 0], "projection": "fish-eye", "fov": 45, "near": 1,
                               "far": 9})"),
         "/camera/projection: neither \"perspective\" nor \"orthographic\""},
        {scene_with_camera(R"({"eye": [0, 0, 5], "target": [0, 0, 0], "projection": "perspective", "height": 45,
                               "near": 1, "far": 9})"),
         "/camera: \"fov\" is missing\nf.json: /camera/height: unknown key"},
        {scene_with_camera(R"({"eye": [0, 0, 5], "target": [0, 0, 5], "projection": "perspective", "fov": 45, "near": 1,
                               "far": 9})"),
         "/camera: eye and target are one point"},
        {scene_with_camera(R"({"eye": [0, 5, 0], "target": [0, 0, 0], "projection": "perspective", "fov": 45, "near": 1,
                               "far": 9})"),
         "/camera: up does not point aside from the direction of view"},
    });
    // z may be anything now, but the shape counts as before.
    const std::string camera = R"("camera": {"eye": [0, 0, 50], "target": [0, 0, 0], "projection": "perspective",
                                             "fov": 45, "near": 1, "far": 99}, )";
    CHECK(message_for(scene_with(polygon_with("[[0, 0, 7], [4, 0, 7], [0, 4, 7]]"), camera)) == "taken");
    const std::string bow = scene_with(polygon_with("[[0, 0, 0], [0, 4, 4], [0, 4, 0], [0, 0, 4]]"), camera);
    CHECK(without_places(message_for(bow)) ==
          "f.json: /polygons/0/vertices/2: not convex, and the edges from [0,0,0] and [0,4,0] cross; cut the polygon "
          "there");
    // In the plane x = 0, but for the last vertex.
    const std::string bent = scene_with(polygon_with("[[0, 0, 0], [0, 4, 0], [0, 4, 4], [1, 0, 4]]"), camera);
    CHECK(without_places(message_for(bent)) ==
          "f.json: /polygons/0/vertices/3: not planar: in the plane of [0,0,0], [0,4,0] and [0,4,4] this vertex would "
          "have x = 0; triangles are always planar");
}

TEST_CASE("everything but the vertices has a default") {
    const auto [scene, warnings] = read_scene(R"({"polygons": [{"vertices": [[-0.5, 2, 0], [4, 2, 0], [1, 5.25, 0]]},
                                                               {"vertices": [[0, 2, 1], [1, 2, 1], [0, 3, 1]]}]})",
                                              "f.json");
    CHECK(warnings.empty());
    CHECK(scene->name.empty());
    CHECK_MESSAGE((scene->area == Area{-1, 2, 5, 4}), "columns from -1/2 to 4, rows from 2 to 5 1/4, in whole pixels");
    CHECK(scene->background == Color{255, 255, 255});
    REQUIRE(scene->polygons.size() == 2);
    CHECK(scene->polygons[0].id == "0");
    CHECK(scene->polygons[1].id == "1");
    CHECK_MESSAGE((scene->polygons[0].color == Color{230, 159, 0}), "Okabe and Ito's orange");
    CHECK_MESSAGE((scene->polygons[1].color == Color{0, 114, 178}), "their blue");
    CHECK(scene_json(scene).find(R"("window":{"x":-1,"y":2,"width":5,"height":4})") != std::string::npos);
}

TEST_CASE("colours repeat after the seventh, by the index in the scene") {
    std::string polygons;
    for (int i = 0; i < 8; ++i) polygons += R"({"vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]},)";
    const AdmittedScene scene = read_scene(scene_with(polygons + triangle), "f.json").scene;
    CHECK(scene->polygons[7].color == scene->polygons[0].color);
    CHECK(scene->polygons[8].color == Color{0x10, 0x20, 0x30});
    for (std::size_t i = 1; i < 7; ++i) CHECK(scene->polygons[i].color != scene->polygons[i - 1].color);
}

TEST_CASE("a default window is at least a pixel each way, and there is none without vertices") {
    CHECK(read_scene(R"({"polygons": [{"vertices": [[2, 3, 0], [2, 3, 0], [2, 3, 0]]}]})", "f.json").scene->area ==
          Area{2, 3, 1, 1});
    check_refused({
        {R"({"polygons": []})", "\"window\" is missing, and there are no vertices to derive it from"},
        {R"({"polygons": [{"vertices": [[0, 0, 0], [16385, 0, 0], [0, 9, 0]]}]})",
         "\"window\" is missing, and the vertices extend too far for one"},
        {R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "projection": "perspective", "fov": 45, "near": 1,
             "far": 9}, "polygons": [{"vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]]}]})",
         "\"window\" is missing, which a camera needs"},
    });
    CHECK(message_for(R"({"polygons": [{"vertices": [[0, 0, 0], [16384, 0, 0], [0, 9, 0]]}]})") == "taken");
}

TEST_CASE("one pass reports every fault in the order of the text, with line, column and path") {
    CHECK(message_for("{\n"
                      "  \"windw\": {\"x\": 0},\n"
                      "  \"background\": \"white\",\n"
                      "  \"polygons\": [\n"
                      "    {\"id\": \"é\", \"vertices\": [[0, 0, 2], [4, 0, 0], [0, 4, 0]]},\n"
                      "    {\"color\": \"#12345\", \"vertices\": [[0, 0], [1, 2, \"3\"]]},\n"
                      "    {}\n"
                      "  ]\n"
                      "}\n") ==
          "f.json: line 2, column 3: /windw: unknown key\n"
          "f.json: line 3, column 17: /background: not a colour of the form \"#rrggbb\"\n"
          "f.json: line 5, column 37: /polygons/0/vertices/0/2: z outside -1 to 1\n"
          "f.json: line 6, column 15: /polygons/1/color: not a colour of the form \"#rrggbb\"\n"
          "f.json: line 6, column 38: /polygons/1/vertices/0: not three coordinates\n"
          "f.json: line 6, column 53: /polygons/1/vertices/1/2: not a hexadecimal number such as \"0x1.8p-3\"\n"
          "f.json: line 7, column 5: /polygons/2: \"vertices\" is missing");
}

TEST_CASE("a fault points at a value, at its key, or at the second of two equal keys") {
    CHECK(message_for(R"({"polygons": [], "a\u0062": {"b": 1}})").find("line 1, column 18: /ab: unknown key") !=
          std::string::npos);
    CHECK(message_for("{\"name\": \"{[\\\"\", \"polygons\": [],\n \"name\": \"b\"}") ==
          "f.json: line 2, column 2: /name: the key occurs twice");
    CHECK(message_for(R"({"polygons": [[[]], {"vertices": [[0, 1e999, 0]]}]})") ==
          "f.json: line 1, column 39: /polygons/1/vertices/0/1: the number is beyond the range of doubles");
}

TEST_CASE("the first twenty of a thousand faults are reported") {
    std::string many;
    for (int i = 0; i < 1000; ++i) many += R"({"vertices": []},)";
    many.pop_back();
    const std::string message = message_for(scene_with(many));
    CHECK(std::count(message.begin(), message.end(), '\n') == 20);
    CHECK(message.find("/polygons/19/vertices: fewer than three vertices\n"
                       "f.json: there may be more faults: reading ended here") != std::string::npos);
}

TEST_CASE("as many polygons as the limit allows, and not one more" * doctest::skip(test::sanitized)) {
    const std::string one = R"({"color":"#000000","vertices":[]},)";
    std::string many;
    for (std::size_t i = 0; i <= most_polygons; ++i) many += one;
    many.pop_back();
    CHECK(without_places(message_for(scene_with(many))) == "f.json: /polygons: more than 1048576 polygons");
}

TEST_CASE("A document without a format has the format of its keys") {
    CHECK(document_format(R"({"window": {}, "polygons": [)") == "vidno-scene/1");
    CHECK(document_format(R"({"curves": []})") == "vidno-surface/1");
    CHECK(document_format(R"({"function": "x"})") == "vidno-surface/1");
    CHECK(document_format(R"({"title": {"polygons": 1}, "fails": {}})") == "vidno-failure/1");
    CHECK_MESSAGE(document_format("{\n \"format\": \"vidno-chart/1\",\n \"curves\": [") == "vidno-chart/1",
                  "what it says counts, if that comes first");
}

TEST_CASE("The format of a document is that of the outermost object, wherever it stands") {
    CHECK(document_format(R"({"format": "vidno-scene/1", "window": {}})") == "vidno-scene/1");
    CHECK(document_format(R"({"a": [1, {"format": "b"}], "format": "vidno-scene/1"})") == "vidno-scene/1");
    CHECK_MESSAGE(document_format(R"({"format": "vidno-scene/1", )") == "vidno-scene/1", "what follows is not read");
    CHECK(document_format(R"({"a": {"format": "b"}})").empty());
    CHECK(document_format(R"({"format": 1, "b": "c"})").empty());
    CHECK(document_format(R"({"format": ["b"]})").empty());
    CHECK(document_format(R"([{"format": "b"}])").empty());
    CHECK(document_format(R"("format")").empty());
    CHECK(document_format("format").empty());
    CHECK(document_format("").empty());
}
