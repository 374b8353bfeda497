/// Fuzz target: any bytes as a surface file are refused, or give curves that can be written and read back unchanged.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "refused.h"
#include "scene/surface.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    std::optional<vidno::Surface> surface;
    try {
        surface = vidno::read_surface(text, "fuzz.json");
    } catch (const vidno::Refused&) {
        return 0;
    }
    if (!(vidno::read_surface(vidno::surface_json(*surface), "again.json") == *surface)) std::abort();
    return 0;
}
