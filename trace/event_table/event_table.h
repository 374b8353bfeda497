/// EventTable: event.h as data, and what follows from it.
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

/// The same without their groups.
std::vector<EventDescription> all_events();

/// The procedures that `call` names: those with a result event. The others are the bottom frames.
std::vector<Procedure> called_procedures();

/// The lists of words with a name of their own, each once.
std::vector<Shape> named_words();

/// The names of lines, in the order of the listings.
std::vector<std::string_view> names_of(const LineSet& lines);

/// The letters of the labels, each once: "W" of W1 to W13.
std::vector<std::string_view> line_letters();

/// A document of which parts are derived. What lacks one of these parts is refused with std::runtime_error.
struct DerivedDocument {
    std::string_view file;  // below trace/
    std::string (*derived)(const std::string& text);
};

/// FORMAT.md with its events and choices, and the schemas with what they list of these.
std::vector<DerivedDocument> derived_documents();

/// FORMAT.md with its derived parts: each is between `<!-- derived: TITLE -->` and `<!-- end -->`.
std::string with_format_tables(const std::string& format);

/// The schema of traces with its events as the table has them, and its header with the choices there are.
std::string with_event_schema(const std::string& schema);

/// The schema of failures with the choices, procedures and lines there are.
std::string with_failure_schema(const std::string& schema);

/// Another schema with the methods there are, of polygons, and perhaps that of curves.
std::string with_methods(const std::string& schema, bool with_floating_horizon);

/// The page's table of events, as TypeScript. Which events a method tells, its listings say.
std::string event_types(const std::string& listings);

}  // namespace vidno
