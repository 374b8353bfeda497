#include "format/trace_reader.h"

#include "choice/kernel_choice.h"
#include "format/quick_event.h"
#include "scene/scene_json.h"

namespace vidno {

namespace {

nlohmann::json parse_line(const std::string& line) {
    try {
        return parse_json(line);
    } catch (const NotJson&) {
        throw Refused("not JSON");
    }
}

void expect_keys(const JsonNode& object, std::initializer_list<std::string_view> keys) {
    for (const auto& key : object.keys()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) object.refuse("unknown key " + key);
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
        if (end.at("partial").value() != true || end.has(result)) end.at("partial").refuse("not true and alone");
        found.partial = true;
        return found;
    }
    const JsonNode hash = member(end, result);
    if (!hash.is_text()) hash.refuse("not a text");
    found.hash = hash.text();
    return found;
}

std::string read_kernel(const JsonNode& node) {
    if (!node.is_text() || !kernel_named(node.text())) node.refuse("not one of " + kernel_names());
    return node.text();
}

/// What headers of both kinds have.
void read_run(const JsonNode& object, auto& header) {
    expect_keys(object, {"format", "method", "edition", "kernel", "detail", "scene"});
    header.edition = Edition(place_of_word(member(object, "edition"), edition_names));
    header.kernel = read_kernel(member(object, "kernel"));
    header.detail = Detail(place_of_word(member(object, "detail"), detail_names));
}

TraceHeader read_header(const JsonNode& object) {
    const JsonNode method = member(object, "method");
    if (method.value() == floating_horizon_method) method.refuse("floating-horizon, which this command does not take");
    TraceHeader header;
    header.method = Method(place_of_word(method, method_names));
    read_run(object, header);
    header.scene = read_scene(member(object, "scene"));
    return header;
}

FloatingHorizonHeader read_floating_horizon_header(const JsonNode& object) {
    FloatingHorizonHeader header;
    read_run(object, header);
    if (!kernel_named(header.kernel)->choice->runs_floating_horizon(header.edition)) {
        object.at("kernel").refuse("no kernel and edition of floating-horizon");
    }
    const JsonNode scene = member(object, "scene");
    if (scene.has("function")) scene.at("function").refuse("a trace has the samples");
    header.scene = read_surface(scene);
    return header;
}

}  // namespace

struct TraceFile::Reading {
    EventContext context;
    std::string_view result;  // the name of what came out
    QuickEvents quick;
    std::optional<Event> otherwise;  // the last event that was not written as the program writes it

    Reading(EventContext by, std::string_view result_name)
        : context(std::move(by)), result(result_name), quick(context) {}
};

TraceFile::TraceFile(LineReader lines, std::string file) : lines_(std::move(lines)), file_(std::move(file)) {
    std::string line;
    if (!lines_.next(line)) throw Refused(file_ + ": empty, not a trace");
    try {
        first_line_ = std::make_unique<nlohmann::json>(parse_line(line));
        if (!first_line_->is_object()) throw Refused("not an object");
        if (!first_line_->contains("format") || (*first_line_)["format"] != "vidno-trace/1") {
            throw Refused("/format: not a trace of format vidno-trace/1");
        }
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

TraceReader::TraceReader(TraceFile file) : TraceFile(std::move(file)), header_(header_by(read_header, "picture")) {}

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
    if (!object.has("e") || !object.at("e").is_text()) throw Refused("/e: no name of an event");
    reading_->otherwise = read_event(object, reading_->context);
    ++events_;
    return reading_->otherwise;
}

}  // namespace vidno
