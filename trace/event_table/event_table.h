/// EventTable: event.h as data, and the documents derived from it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "event_table/shape.h"

namespace vidno {

struct FieldDescription {
    std::string_view name;
    Shape shape;
    Meaning meaning;
    bool is_optional = false;
};

struct EventDescription {
    std::string_view name;
    Detail from{};
    LineSet lines;
    std::string_view says;
    std::optional<Procedure> result_of;
    std::optional<Decision> decides;
    std::vector<FieldDescription> fields;
};

/// The events of a table in FORMAT.md.
struct EventGroup {
    std::string_view title;
    std::vector<EventDescription> events;
};

/// All events, each once.
std::vector<EventGroup> event_table();

/// All events, without their groups.
std::vector<EventDescription> all_events();

/// The procedures that `call` names: those with a result event. The others are the bottom frames.
std::vector<Procedure> called_procedures();

/// The lists of words with a name of their own, each once.
std::vector<Shape> named_words();

/// The labels of lines, in the order of the listings.
std::vector<std::string_view> names_of(const LineSet& lines);

/// The letters of the labels, each once: "W" of W1 to W13.
std::vector<std::string_view> line_letters();

/// A document with derived parts. If one of these parts is missing, std::runtime_error is thrown.
struct DerivedDocument {
    std::string_view file;  // below trace/
    std::string (*derived)(const std::string& text);
};

/// FORMAT.md with its events and choices, and the schemas with the ones they list.
std::vector<DerivedDocument> derived_documents();

/// FORMAT.md with its derived parts, each between `<!-- derived: TITLE -->` and `<!-- end -->`.
std::string with_format_tables(const std::string& format);

/// The schema of traces with the events of the table, and with the choices in its header.
std::string with_event_schema(const std::string& schema);

/// The schema of failures with the choices, procedures and lines.
std::string with_failure_schema(const std::string& schema);

/// Another schema with the methods for polygons, and perhaps the one for curves.
std::string with_methods(const std::string& schema, bool with_floating_horizon);

/// The types of events and of the values of states for the page, as TypeScript, with what it asks about events. The
/// listings determine the events of each method.
std::string page_types(const std::string& listings);

/// [{"en": TEXT, "ru": TEXT}, ...]: the names of the course's scenes.
std::string scene_names_json();

}  // namespace vidno
