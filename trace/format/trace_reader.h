/// TraceReader: reads a trace file of polygons, event by event; FloatingHorizonTraceReader: reads one of curves.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <variant>

#include "format/event_reader.h"
#include "format/floating_horizon_trace.h"
#include "format/run_losses.h"
#include "format/trace_writer.h"
#include "output.h"

namespace vidno {

class JsonNode;

/// A trace whose first line was read: everything that is the same for polygons and curves.
class TraceFile {
public:
    /// `file` is its name in messages. Throws Refused.
    TraceFile(LineReader lines, std::string file);
    TraceFile(TraceFile&&) noexcept;
    ~TraceFile();

    /// The next event, valid until the one after it is read; none at the end. Throws Refused, with the line number, for
    /// a line that is not an event.
    std::optional<EventView> next();

    /// Passes over the rest of the file without reading its events, up to the last line.
    void skip_rest();

    /// After the last event: the contents of the last line, none if the file was cut short.
    const std::optional<TraceEnd>& end() const { return reader_->end(); }

    std::uint64_t events() const { return reader_->events(); }

    /// What the run has lost, as the events that were read tell it.
    std::vector<Loss> losses() const { return losses_->all(names_); }
    /// What the file lacks, after the last event: it may be cut short, or hold only a part of a run.
    std::optional<Loss> lacks() const;

    const std::string& file() const { return file_; }
    /// `file:line` for the line that was read last.
    std::string place() const { return file_ + ":" + std::to_string(line_number_); }

    bool is_of_curves() const;

protected:
    /// Reads the first line by `read`; `result` is the key of the result in the last line.
    template <class Header>
    Header header_by(Header (*read)(const JsonNode&), std::string_view result);

private:
    LineReader lines_;
    std::string file_;
    std::string line_;
    std::unique_ptr<nlohmann::json> first_line_;  // until the header is read
    std::unique_ptr<EventReader> reader_;         // once the header is read
    PolygonNames names_;                          // and so are these
    std::optional<RunLosses> losses_;
    std::uint64_t line_number_ = 1;
};

class TraceReader : public TraceFile {
public:
    /// Reads the header. `file` is its name in messages. Throws Refused.
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

/// A trace of either kind, for code that handles both by `std::visit`.
using AnyTraceReader = std::variant<TraceReader, FloatingHorizonTraceReader>;

/// Reads the header. `file` is its name in messages. Throws Refused.
AnyTraceReader open_trace(LineReader lines, std::string file);

}  // namespace vidno
