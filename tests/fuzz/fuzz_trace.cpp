// Any bytes as a trace: read, and applied step by step. Either is refused in words, or the state stays whole.

#include <cstddef>
#include <cstdint>

#include "state.h"
#include "trace_reader.h"

using namespace vidno;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        TraceReader reader(LineReader::of_text({reinterpret_cast<const char*>(data), size}), "trace");
        const Area& area = reader.header().scene.area;
        if (std::int64_t{area.width} * area.height > 1 << 16) return 0;  // a large picture is no fault, only slow
        State state(reader.header());
        while (const auto event = reader.next()) state.apply(*event);
        state_json(state);
    } catch (const Refused&) {
    } catch (const Impossible&) {
    }
    return 0;
}
