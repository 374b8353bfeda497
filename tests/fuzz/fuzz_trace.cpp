// Any bytes as a trace: read, and applied step by step. Either is refused in words, or the state stays whole.

#include <cstddef>
#include <cstdint>

#include "curve_state.h"
#include "state.h"
#include "trace_reader.h"

using namespace vidno;

namespace {

template <class State>
void follow(auto& reader, const Area& area) {
    if (std::int64_t{area.width} * area.height > 1 << 16) return;  // a large picture is no fault, only slow
    State state(reader.header());
    while (const auto event = reader.next()) state.apply(*event);
    state_json(state);
}
void follow(TraceReader& reader) { follow<State>(reader, reader.header().scene.area); }
void follow(CurveTraceReader& reader) { follow<CurveState>(reader, reader.header().scene.curves.area); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        AnyTraceReader opened = open_trace(LineReader::of_text({reinterpret_cast<const char*>(data), size}), "trace");
        std::visit([](auto& reader) { follow(reader); }, opened);
    } catch (const Refused&) {
    } catch (const Impossible&) {
    }
    return 0;
}
