/// EventReader: reads the lines of a trace after its first.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "format/quick_event.h"

namespace vidno {

/// The contents of the last line.
struct TraceEnd {
    std::uint64_t events = 0;
    std::string hash;  // of the picture or the lines; empty if partial
    bool partial = false;
};

class EventReader {
public:
    /// `result` is the key of the result in the last line: "picture" or "lines".
    EventReader(EventContext context, std::string_view result)
        : context_(std::move(context)), quick_(context_), result_(result) {}
    EventReader(const EventReader&) = delete;
    EventReader& operator=(const EventReader&) = delete;

    /// The next event, valid until another is read; none for the last line of the trace. Throws Refused with the path
    /// in the line and the reason.
    std::optional<EventView> next(std::string_view line);
    /// Counts events that are not read.
    void skip(std::uint64_t events) { events_ += events; }
    /// An event that `next` has read before.
    EventView again(std::string_view line);

    /// The contents of the last line, once it was read.
    const std::optional<TraceEnd>& end() const { return end_; }
    /// How many events were read.
    std::uint64_t events() const { return events_; }

private:
    EventContext context_;
    QuickEvents quick_;
    std::string_view result_;
    std::optional<Event> otherwise_;  // the last event not in the form that the program writes
    std::optional<TraceEnd> end_;
    std::uint64_t events_ = 0;
};

}  // namespace vidno
