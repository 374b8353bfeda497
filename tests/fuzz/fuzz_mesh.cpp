/// Fuzz target: any bytes as a mesh are refused, or give a scene that reads back the same. The first byte selects the
/// format, so that one corpus serves all four.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "import/import.h"
#include "refused.h"
#include "scene/scene_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    constexpr std::array<const char*, 4> files{"fuzz.obj", "fuzz.off", "fuzz.ply", "fuzz.stl"};
    const std::string file = files[data[0] % files.size()];
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    vidno::Scene scene;
    try {
        scene = vidno::import_mesh(bytes, file, {}).scene;
    } catch (const vidno::Refused&) {
        return 0;
    }
    const auto again = vidno::read_scene(vidno::scene_json(scene), "again.json");
    if (!(again.scene == scene) || !again.warnings.empty()) std::abort();
    return 0;
}
