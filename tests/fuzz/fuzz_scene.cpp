/// Fuzz target: any bytes as a scene file are refused, or give a scene that can be written and read back unchanged. The
/// quick reader agrees with the tree.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "refused.h"
#include "scene/scene_json.h"
#include "support/agreement.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (!vidno::test::agreement_on_scene(text).agrees) std::abort();
    vidno::Scene scene;
    try {
        scene = vidno::read_scene(text, "fuzz.json").scene;
    } catch (const vidno::Refused&) {
        return 0;
    }
    const auto again = vidno::read_scene(vidno::scene_json(scene), "again.json");
    if (!(*again.scene == scene) || !again.warnings.empty()) std::abort();
    return 0;
}
