/// Meshes as public reports describe them, restated as small inputs: inputs.json. README.md says what became of each.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "import/import.h"
#include "import/mesh_soup.h"
#include "json/json_text.h"
#include "refused.h"
#include "support/workplace.h"

using namespace vidno;
using nlohmann::json;

namespace {

/// Corners by face; of faces that have an area, as the scene has them.
json faces_of(const MeshSoup& soup) {
    json faces = json::array();
    for (const MeshFace& face : soup.faces) {
        json corners = json::array();
        for (const std::size_t i : face.corners) {
            corners.push_back({soup.points[i].x, soup.points[i].y, soup.points[i].z});
        }
        if (corners.size() >= 3) faces.push_back(corners);
    }
    return faces;
}

}  // namespace

TEST_CASE("what public reports bring is read as they expect it, or refused with its reason") {
    const std::string log = text_of(VIDNO_ROOT "/tests/wild/README.md");
    for (const json& input : json::parse(text_of(VIDNO_ROOT "/tests/wild/inputs.json"))) {
        const std::string source = input["source"], text = input["text"], file = input["file"];
        CAPTURE(source);
        CHECK(log.find(source) != std::string::npos);
        const json beside_it = input.value("beside", json::object());
        const Beside beside = [&](const std::string& name) -> std::optional<std::string> {
            return beside_it.contains(name) ? std::optional(beside_it[name].get<std::string>()) : std::nullopt;
        };
        try {
            const auto [scene, report, losses] = import_mesh(text, file, {}, beside);
            REQUIRE(input.contains("faces"));
            CHECK(faces_of(read_mesh_soup(text, file, beside)) == input["faces"]);
            json reported = json::array();
            for (const auto& [what, where] : losses) reported.push_back(where + ": " + what);
            CHECK(reported == input["told"]);
            for (std::size_t i = 0; input.contains("colors") && i < scene->polygons.size(); ++i) {
                CHECK(scene->polygons[i].color == *color_of_hex(input["colors"][i].get<std::string>()));
            }
        } catch (const Refused& refused) {
            CHECK(input.value("refused", "read") == refused.what());
        }
    }
}
