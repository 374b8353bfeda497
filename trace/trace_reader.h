/// TraceReader: a trace file, event by event.
#pragma once

#include <map>

#include "output.h"
#include "trace_writer.h"

namespace vidno {

/// What the last line says.
struct TraceEnd {
    std::uint64_t events = 0;
    std::string picture;  // the hash; empty if partial
    bool partial = false;
};

class TraceReader {
public:
    /// Reads the header. `file` is the name in messages. Throws Refused.
    TraceReader(LineReader lines, std::string file);

    const TraceHeader& header() const { return header_; }

    /// The next event, none at the end. Throws Refused, with the line, for anything that is not one.
    std::optional<Event> next();

    /// After the last event: what the file says of itself, none if it was cut short.
    const std::optional<TraceEnd>& end() const { return end_; }

    std::uint64_t events() const { return events_; }

    /// `file:line`, of the line that was read last.
    std::string place() const { return file_ + ":" + std::to_string(line_number_); }

private:
    std::optional<Event> parse(const std::string& line);

    LineReader lines_;
    std::string file_;
    TraceHeader header_;
    std::map<std::string, int, std::less<>> places_;  // of the polygons, by id
    std::optional<TraceEnd> end_;
    std::uint64_t events_ = 0;
    std::uint64_t line_number_ = 1;
};

}  // namespace vidno
