/// TraceWriter: the sink that writes events as a trace file, header and last line included.
#pragma once

#include <cstdint>
#include <functional>

#include "event_json.h"
#include "vidno/vidno.h"

namespace vidno {

struct TraceHeader {
    Method method{};
    std::string edition;
    std::string kernel;
    Detail detail{};
    Scene scene;
    bool operator==(const TraceHeader&) const = default;
};

/// The first line of a trace.
std::string header_json(const TraceHeader& header);

/// "sha256:" and the hash of the rows from the top, three bytes R, G, B a pixel.
std::string picture_hash(const Picture& picture);

/// Thrown out of a run that has told as many events as it may; finish_partial keeps what was told.
struct EventLimitReached {};

class TraceWriter {
public:
    using Write = std::function<void(std::string_view)>;
    static constexpr std::uint64_t no_limit = ~std::uint64_t{0};

    TraceWriter(const TraceHeader& header, Write write, std::uint64_t most_events = no_limit);

    template <class E>
    void operator()(const E& event) {
        if (events_ == most_events_) throw EventLimitReached{};
        ++events_;
        lines_.line(text_, event);
        if (text_.size() > block) flush();
    }

    void finish(const Picture& picture);
    void finish_partial();

    std::uint64_t events() const { return events_; }

private:
    static constexpr std::size_t block = std::size_t{1} << 16;

    void flush();

    EventText lines_;
    Write write_;
    std::uint64_t most_events_;
    std::uint64_t events_ = 0;
    Text text_;
};

}  // namespace vidno
