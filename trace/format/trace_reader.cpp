#include "format/trace_reader.h"

#include "counted.h"
#include "format/event_reader.h"
#include "format/trace_header.h"
#include "json/json_node.h"

namespace vidno {

namespace {

const std::string damage = "damaged: its compressed data end too early or fail their checksum";

}  // namespace

TraceFile::TraceFile(LineReader lines, std::string file) : lines_(std::move(lines)), file_(std::move(file)) {
    std::string line;
    if (!lines_.next(line)) throw Refused(file_ + ": " + (lines_.damaged() ? damage : "empty, not a trace"));
    try {
        first_line_ = std::make_unique<nlohmann::json>(parse_line(line));
        expect_trace(*first_line_);
    } catch (const Refused& refused) {
        throw Refused(place() + ": " + refused.what());
    }
}
TraceFile::TraceFile(TraceFile&&) noexcept = default;
TraceFile::~TraceFile() = default;

bool TraceFile::is_of_curves() const { return vidno::is_of_curves(*first_line_); }

template <class Header>
Header TraceFile::header_by(Header (*read)(const JsonNode&), std::string_view result) {
    try {
        Header header = read(JsonNode(*first_line_));
        first_line_.reset();
        names_ = polygon_names(header.scene);
        losses_.emplace(header.kernel);
        reader_ = std::make_unique<EventReader>(
            EventContext{header.detail, header.kernel == "exact", KnownPolygons(names_)}, result);
        return header;
    } catch (const Refused& refused) {
        throw Refused(place() + ": " + refused.what());
    }
}

TraceReader::TraceReader(TraceFile file)
    : TraceFile(std::move(file)), header_(header_by(read_trace_header, "picture")) {}

FloatingHorizonTraceReader::FloatingHorizonTraceReader(TraceFile file)
    : TraceFile(std::move(file)), header_(header_by(read_floating_horizon_header, "lines")) {}

AnyTraceReader open_trace(LineReader lines, std::string file) {
    TraceFile opened(std::move(lines), std::move(file));
    if (opened.is_of_curves()) return FloatingHorizonTraceReader(std::move(opened));
    return TraceReader(std::move(opened));
}

std::optional<EventView> TraceFile::next() {
    if (end() || !lines_.next(line_)) return std::nullopt;
    ++line_number_;
    try {
        const auto event = reader_->next(line_);
        if (!event && lines_.next(line_)) throw Refused("text after the last line");
        if (event) losses_->hear(*event);
        return event;
    } catch (const Refused& refused) {
        if (lines_.cut()) return std::nullopt;
        throw Refused(place() + ": " + refused.what());
    }
}

void TraceFile::skip_rest() {
    if (end()) return;
    std::string last;
    std::uint64_t lines = 0;
    for (; lines_.next(line_); ++lines) last.swap(line_);
    if (lines == 0) return;
    line_number_ += lines;
    reader_->skip(lines - 1);
    try {
        reader_->next(last);
    } catch (const Refused& refused) {
        if (!lines_.cut()) throw Refused(place() + ": " + refused.what());
    }
}

std::optional<Loss> TraceFile::lacks() const {
    const std::string read = counted(events(), "event", "events");
    if (lines_.damaged()) return Loss{damage + "; " + read + " read", {}};
    if (!end()) return Loss{"cut short: " + read + " read, the last line is missing", {}};
    if (end()->partial) return Loss{"partial: the run was stopped after " + read, {}};
    return std::nullopt;
}

}  // namespace vidno
