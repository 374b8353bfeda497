// Any bytes as a trace: read, and applied step by step. Either step refuses with a message, or the state stays
// consistent. The quick reader agrees with the tree.

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "format/trace_reader.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "support/agreement.h"

using namespace vidno;

namespace {

template <class State>
void follow(auto& reader, const Area& area) {
    if (std::int64_t{area.width} * area.height > 1 << 16) return;  // a large picture is not an error, only slow
    State state(reader.header());
    while (const auto event = reader.next()) state.apply(*event);
    state_json(state);
}

/// Stops the fuzzer where the readers of a line disagree.
void compare_readers(const auto& header, std::string_view text) {
    const PolygonNames names = polygon_names(header.scene);
    const EventContext context{header.detail, header.kernel == "exact", KnownPolygons(names)};
    LineReader lines = LineReader::of_text(std::string(text));
    for (std::string line; lines.next(line);) {
        if (!test::agreement_on_event(line, context, names).agrees) std::abort();
    }
}
void follow(TraceReader& reader) { follow<State>(reader, reader.header().scene.area); }
void follow(FloatingHorizonTraceReader& reader) {
    follow<FloatingHorizonState>(reader, reader.header().scene.curves->area);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string text(reinterpret_cast<const char*>(data), size);
        AnyTraceReader opened = open_trace(LineReader::of_text(text), "trace");
        std::visit([&](const auto& reader) { compare_readers(reader.header(), text); }, opened);
        std::visit([](auto& reader) { follow(reader); }, opened);
    } catch (const Refused&) {
    } catch (const Impossible&) {
    }
    return 0;
}
