/// TraceWriter: the sink that writes events as a trace file, header and last line included.
#pragma once

#include <cstdint>
#include <functional>

#include "choice/edition.h"
#include "format/event_sink.h"
#include "format/event_text.h"
#include "format/run_losses.h"
#include "vidno/picture.h"

namespace vidno {

struct TraceHeader {
    Method method{};
    Edition edition{};
    std::string kernel;
    Detail detail{};
    Scene scene;
    bool operator==(const TraceHeader&) const = default;
};

/// The first line of a trace.
std::string header_json(const TraceHeader& header);

/// "sha256:" and the hash of the bytes.
std::string hash_text(std::string_view bytes);

/// The hash of the rows from the top, three bytes R, G, B for each pixel.
std::string picture_hash(const Picture& picture);

/// Thrown to end a run that reaches its limit of events; finish_partial keeps the events so far.
struct EventLimitReached {};

class TraceWriter final : public EventSink {
public:
    using Write = std::function<void(std::string_view)>;
    static constexpr std::uint64_t no_limit = ~std::uint64_t{0};

    /// The header belongs to a run of any kind.
    template <class Header = TraceHeader>
    TraceWriter(const Header& header, Write write, std::uint64_t most_events = no_limit)
        : TraceWriter(header_json(header), polygon_names(header.scene), header.kernel, std::move(write), most_events) {}

    /// Throws EventLimitReached instead of writing more events than the limit.
    void hear(const EventView& event) override;

    void finish(const Picture& picture) { finish("picture", picture_hash(picture)); }
    /// The key and the hash of the result.
    void finish(std::string_view result, const std::string& hash);
    void finish_partial();

    std::uint64_t events() const { return events_; }

    /// What the run has lost so far.
    std::vector<Loss> losses() const { return losses_.all(lines_.names()); }

private:
    static constexpr std::size_t block = std::size_t{1} << 16;

    TraceWriter(std::string_view first_line, PolygonNames names, std::string_view kernel, Write write,
                std::uint64_t most_events);

    void finish_with(std::string_view rest);
    void flush();

    EventText lines_;
    RunLosses losses_;
    Write write_;
    std::uint64_t most_events_;
    std::uint64_t events_ = 0;
    Text text_;
};

}  // namespace vidno
