#include "format/trace_reader.h"

#include "format/quick_event.h"
#include "format/trace_header.h"
#include "json/json_node.h"

namespace vidno {

namespace {

nlohmann::json parse_line(const std::string& line) {
    try {
        return parse_json(line);
    } catch (const NotJson&) {
        throw Refused("not JSON");
    }
}

TraceEnd read_end(const JsonNode& object, std::string_view result) {
    expect_keys(object, {"end"});
    const JsonNode end = object.at("end");
    expect_keys(end, {"events", result, "partial"});
    TraceEnd found;
    const JsonNode events = member(end, "events");
    if (!events.value().is_number_unsigned()) events.refuse("not a count");
    found.events = events.value().get<std::uint64_t>();
    if (end.has("partial")) {
        if (end.at("partial").value() != true || end.has(result))
            end.at("partial").refuse("must be true, without a result beside it");
        found.partial = true;
        return found;
    }
    const JsonNode hash = member(end, result);
    if (!hash.is_text()) hash.refuse("not a string");
    found.hash = hash.text();
    return found;
}

}  // namespace

struct TraceFile::Reading {
    EventContext context;
    std::string_view result;  // the key of the result: "picture" or "lines"
    QuickEvents quick;
    std::optional<Event> otherwise;  // the last event not in the form that the program writes

    Reading(EventContext by, std::string_view result_name)
        : context(std::move(by)), result(result_name), quick(context) {}
};

TraceFile::TraceFile(LineReader lines, std::string file) : lines_(std::move(lines)), file_(std::move(file)) {
    std::string line;
    if (!lines_.next(line)) throw Refused(file_ + ": empty, not a trace");
    try {
        first_line_ = std::make_unique<nlohmann::json>(parse_line(line));
        if (!first_line_->is_object()) throw Refused("not an object");
        if (!first_line_->contains("format")) throw Refused("/format: not a trace of format vidno-trace/1");
        JsonNode(*first_line_).expect_format("vidno-trace/1");
    } catch (const Refused& refused) {
        throw Refused(place() + ": " + refused.what());
    }
}
TraceFile::TraceFile(TraceFile&&) noexcept = default;
TraceFile::~TraceFile() = default;

bool TraceFile::is_of_curves() const {
    return first_line_->contains("method") && (*first_line_)["method"] == floating_horizon_method;
}

template <class Header>
Header TraceFile::header_by(Header (*read)(const JsonNode&), std::string_view result) {
    try {
        Header header = read(JsonNode(*first_line_));
        first_line_.reset();
        reading_ = std::make_unique<Reading>(
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
    if (end_ || !lines_.next(line_)) return std::nullopt;
    ++line_number_;
    if (const auto event = reading_->quick.read(line_)) {
        ++events_;
        return event;
    }
    try {
        return read_otherwise();
    } catch (const Refused& refused) {
        if (lines_.cut()) return std::nullopt;
        throw Refused(place() + ": " + refused.what());
    }
}

std::optional<EventView> TraceFile::read_otherwise() {
    const nlohmann::json line = parse_line(line_);
    const JsonNode object(line);
    object.object();
    if (!object.has("e") && object.has("end")) {
        end_ = read_end(object, reading_->result);
        if (end_->events != events_) object.at("end").at("events").refuse("not the number of events read");
        if (lines_.next(line_)) throw Refused("text after the last line");
        return std::nullopt;
    }
    if (!object.has("e") || !object.at("e").is_text()) throw Refused("/e: not the name of an event");
    reading_->otherwise = read_event(object, reading_->context);
    ++events_;
    return reading_->otherwise;
}

}  // namespace vidno
