#include "format/event_reader.h"

#include "format/trace_header.h"
#include "format/tree_event.h"
#include "json/json_node.h"

namespace vidno {

namespace {

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

std::optional<EventView> EventReader::next(std::string_view line) {
    if (end_) throw Refused("text after the last line");
    if (const auto event = quick_.read(line)) {
        ++events_;
        return event;
    }
    const nlohmann::json parsed = parse_line(line);
    const JsonNode object(parsed);
    object.object();
    if (!object.has("e") && object.has("end")) {
        TraceEnd end = read_end(object, result_);
        if (end.events != events_) object.at("end").at("events").refuse("not the number of events read");
        end_ = std::move(end);
        return std::nullopt;
    }
    if (!object.has("e") || !object.at("e").is_text()) throw Refused("/e: not the name of an event");
    otherwise_ = read_event(object, context_);
    ++events_;
    return otherwise_;
}

EventView EventReader::again(std::string_view line) {
    if (const auto event = quick_.read(line)) return *event;
    const nlohmann::json parsed = parse_line(line);
    otherwise_ = read_event(JsonNode(parsed), context_);
    return *otherwise_;
}

}  // namespace vidno
