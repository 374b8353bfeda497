#include "wasm/reading.h"

#include "format/quick_event.h"
#include "format/trace_header.h"
#include "json/json_node.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"

namespace vidno {

struct Reading::Run {
    EventContext context;
    QuickEvents quick{context};

    explicit Run(EventContext of) : context(std::move(of)) {}
    virtual ~Run() = default;
    /// Throws Impossible.
    virtual void apply(const EventView& event) = 0;
};

template <class State, class Header>
struct Reading::RunOf final : Run {
    Header header;
    State state{header};

    explicit RunOf(Header of)
        : Run({of.detail, of.kernel == "exact", KnownPolygons(polygon_names(of.scene))}), header(std::move(of)) {}
    void apply(const EventView& event) override { state.apply(event); }
};

Reading::Reading(std::string_view first_line) {
    read_json(first_line, "trace", [this](const JsonNode& object) {
        if (member(object, "method").value() == floating_horizon_method) {
            run_ = std::make_unique<RunOf<FloatingHorizonState, FloatingHorizonHeader>>(
                read_floating_horizon_header(object));
        } else {
            run_ = std::make_unique<RunOf<State, TraceHeader>>(read_trace_header(object));
        }
        return true;
    });
}

Reading::~Reading() = default;

void Reading::take(std::string_view text, LineIndex& lines) {
    std::size_t start = 0;
    try {
        for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', start)) {
            const auto event = run_->quick.read(text.substr(start, end - start));
            if (!event) break;
            run_->apply(*event);
            lines.starts.push_back(std::uint32_t(start));
            lines.names.push_back(std::uint8_t(event->place()));
            start = end + 1;
        }
    } catch (const Impossible&) {
        // Another reader reports why.
    }
    lines.starts.push_back(std::uint32_t(start));
}

}  // namespace vidno
