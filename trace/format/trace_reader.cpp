#include "format/trace_reader.h"

#include "format/event_reader.h"
#include "format/trace_header.h"
#include "json/json_node.h"

namespace vidno {

TraceFile::TraceFile(LineReader lines, std::string file) : lines_(std::move(lines)), file_(std::move(file)) {
    std::string line;
    if (!lines_.next(line)) throw Refused(file_ + ": empty, not a trace");
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
        reader_ = std::make_unique<EventReader>(
            EventContext{header.detail, header.kernel == "exact", KnownPolygons(polygon_names(header.scene))}, result);
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
        return event;
    } catch (const Refused& refused) {
        if (lines_.cut()) return std::nullopt;
        throw Refused(place() + ": " + refused.what());
    }
}

}  // namespace vidno
