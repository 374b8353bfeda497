/// TraceReader: a trace file of polygons, event by event; FloatingHorizonTraceReader: one of curves.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <variant>

#include "format/floating_horizon_trace.h"
#include "format/trace_writer.h"
#include "output.h"

namespace vidno {

class JsonNode;

/// What the last line says.
struct TraceEnd {
    std::uint64_t events = 0;
    std::string hash;  // of the picture or the lines; empty if partial
    bool partial = false;
};

/// A trace of which the first line was read: all that does not depend on what the run was of.
class TraceFile {
public:
    /// `file` is the name in messages. Throws Refused.
    TraceFile(LineReader lines, std::string file);
    TraceFile(TraceFile&&) noexcept;
    ~TraceFile();

    /// The next event, which lies here until the one after it is read; none at the end. Throws Refused, with the line, for anything that
    /// is not one.
    std::optional<EventView> next();

    /// After the last event: what the file says of itself, none if it was cut short.
    const std::optional<TraceEnd>& end() const { return end_; }

    std::uint64_t events() const { return events_; }

    /// `file:line`, of the line that was read last.
    std::string place() const { return file_ + ":" + std::to_string(line_number_); }

    bool is_of_curves() const;

protected:
    /// What `read` makes of the first line; `result` is the name of what came out.
    template <class Header>
    Header header_by(Header (*read)(const JsonNode&), std::string_view result);

private:
    struct Reading;

    std::optional<EventView> read_otherwise();

    LineReader lines_;
    std::string file_;
    std::string line_;
    std::unique_ptr<nlohmann::json> first_line_;  // until the header is read
    std::unique_ptr<Reading> reading_;
    std::optional<TraceEnd> end_;
    std::uint64_t events_ = 0;
    std::uint64_t line_number_ = 1;
};

class TraceReader : public TraceFile {
public:
    /// Reads the header. `file` is the name in messages. Throws Refused.
    TraceReader(LineReader lines, std::string file) : TraceReader(TraceFile(std::move(lines), std::move(file))) {}
    explicit TraceReader(TraceFile file);

    const TraceHeader& header() const { return header_; }

private:
    TraceHeader header_;
};

class FloatingHorizonTraceReader : public TraceFile {
public:
    /// Reads the header. Throws Refused.
    explicit FloatingHorizonTraceReader(TraceFile file);

    const FloatingHorizonHeader& header() const { return header_; }

private:
    FloatingHorizonHeader header_;
};

/// A trace of either kind, for what does the same with both: `std::visit`.
using AnyTraceReader = std::variant<TraceReader, FloatingHorizonTraceReader>;

/// Reads the header. `file` is the name in messages. Throws Refused.
AnyTraceReader open_trace(LineReader lines, std::string file);

}  // namespace vidno
