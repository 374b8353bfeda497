/// vidno_mesh: reads the meshes whose names are on standard input, a line each, and prints what was read as a line of
/// JSON each. compare.py compares it with a second reader.
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "import/import.h"
#include "import/mesh_soup.h"
#include "output.h"
#include "refused.h"

namespace {

using namespace vidno;
using nlohmann::json;

json reported(const std::string& file) {
    MeshSoup soup = read_mesh_soup(read_file(file), file, files_beside(file));
    const auto colors = face_colors(soup);
    json out{{"points", json::array()},
             {"faces", json::array()},
             {"colors", json::array()},
             {"groups", json::array()},
             {"losses", json::array()}};
    for (const auto& point : soup.points) out["points"].push_back({point.x, point.y, point.z});
    for (std::size_t i = 0; i < soup.faces.size(); ++i) {
        const MeshFace& face = soup.faces[i];
        const auto& color = colors[i];
        out["faces"].push_back(face.corners);
        out["colors"].push_back(color ? json{color->red, color->green, color->blue} : json());
        out["groups"].push_back(face.group ? json(soup.groups[*face.group]) : json());
    }
    for (const auto& [what, where] : soup.left_out.losses()) out["losses"].push_back(where + ": " + what);
    return out;
}

}  // namespace

int main() {
    for (std::string file; std::getline(std::cin, file);) {
        try {
            std::cout << reported(file) << '\n';
        } catch (const Refused& refused) {
            std::cout << json{{"refused", std::string(refused.what()).substr(file.size() + 2)}} << '\n';
        }
    }
}
