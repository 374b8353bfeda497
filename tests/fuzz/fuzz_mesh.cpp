/// Fuzz target: the import of meshes refuses any bytes or returns a scene that reads back the same. The first byte
/// selects the format, '0' for the first of mesh_formats, so one corpus serves all formats.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "import/import.h"
#include "import/mesh_soup.h"
#include "refused.h"
#include "scene/scene_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto format = unsigned(data[0] - '0') % vidno::mesh_formats.size();
    const std::string file = "fuzz." + std::string(vidno::mesh_formats[format].ending);
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    vidno::Scene scene;
    try {
        scene = vidno::import_mesh(bytes, file, {}).scene;
    } catch (const vidno::Refused&) {
        return 0;
    }
    const auto again = vidno::read_scene(vidno::scene_json(scene), "again.json");
    if (!(*again.scene == scene) || !again.warnings.empty()) std::abort();
    return 0;
}
