/// Reads an event from a line's tree of JSON values, with keys in any order. Errors are refused with their path.
///
/// quick_event.h reads the lines that the program writes, which are most; this reader takes the others.
#pragma once

#include "format/event.h"
#include "format/known_polygons.h"
#include "json/json_node.h"

namespace vidno {

/// The properties of a trace's events that its header determines.
struct EventContext {
    Detail detail{};
    bool is_exact = false;  // numbers may be fractions
    KnownPolygons polygons{};
};

/// The values of a line. Throws Refused.
nlohmann::json parse_line(std::string_view line);

/// Throws Refused.
Event read_event(const JsonNode& object, const EventContext& context);

/// The member of an object. Throws Refused if there is none.
JsonNode member(const JsonNode& object, std::string_view key);

}  // namespace vidno
