// The events of schema/trace.schema.json, the words of its header, and those of schema/failure.schema.json.

#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "choice/kernel_choice.h"
#include "choice/language.h"
#include "choice/method.h"
#include "event_table/event_table.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

Json reference(std::string_view name) { return {{"$ref", "#/$defs/" + std::string(name)}}; }

Json tuple_of(const Json& items) {
    return {{"type", "array"}, {"prefixItems", items}, {"items", false}, {"minItems", items.size()}};
}

Json schema_of(const Shape& shape, const Meaning& meaning) {
    if (!shape.name.empty()) return reference(shape.name);
    switch (shape.kind) {
        case Shape::Kind::named: break;
        case Shape::Kind::words: return {{"enum", shape.words}};
        case Shape::Kind::numbers: return {{"enum", shape.numbers}};
        case Shape::Kind::list: return {{"type", "array"}, {"items", schema_of(shape.items.front(), meaning)}};
        case Shape::Kind::integer: {
            Json whole_number{{"type", "integer"}};
            if (meaning.least != any_number.least) whole_number["minimum"] = meaning.least;
            if (meaning.most != any_number.most) whole_number["maximum"] = meaning.most;
            return whole_number;
        }
        case Shape::Kind::tuple: {
            Json items = Json::array();
            for (const auto& item : shape.items) items.push_back(schema_of(item, meaning));
            return tuple_of(items);
        }
    }
    return {};
}

Json schema_of(const LineSet& lines) {
    if (lines == LineSet::all()) return reference("label");
    return {{"enum", names_of(lines)}};
}

Json schema_of(const EventDescription& event) {
    Json properties{{"e", {{"const", event.name}}}, {"at", schema_of(event.lines)}};
    Json required{"e", "at"};
    for (const auto& field : event.fields) {
        properties[std::string(field.name)] = schema_of(field.shape, field.meaning);
        if (!field.is_optional) required.push_back(field.name);
    }
    return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

/// The names of kernels, each number written out.
std::string kernel_pattern() {
    std::string names;
    for (const auto& choice : kernel_choices) {
        names += (names.empty() ? "" : "|") + std::string(choice.name);
        if (!choice.parameter) continue;
        for (int number = choice.parameter->least; number <= choice.parameter->most; ++number) {
            names += (number == choice.parameter->least ? ":(" : "|") + std::to_string(number);
        }
        names += ")";
    }
    return "^(" + names + ")$";
}

/// The labels of lines: "W7".
std::string label_pattern() {
    std::string letters;
    for (const auto own : line_letters()) letters += (letters.empty() ? "" : "|") + std::string(own);
    return "^(" + letters + ")[1-9][0-9]?$";
}

/// The names of the editions that `exist`: those with a name of their own, and single defects.
std::string edition_pattern(auto&& exist) {
    std::string names, defects;
    for (const auto& named : named_editions) {
        if (exist(named.edition)) names += std::string(named.name) + "|";
    }
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        const auto& defect = deviations[i].defect;
        if (!defect.empty() && exist(Deviation(i))) defects += (defects.empty() ? "" : "|") + std::string(defect);
    }
    return "^(" + names + "printed:(" + defects + ")([+](" + defects + "))*)$";
}

constexpr auto any_edition = [](Edition) { return true; };
constexpr auto edition_of_curves = [](Edition edition) { return has_text_of_curves(edition); };

Json all_methods() {
    Json names = method_names;
    names.push_back(floating_horizon_method);
    return names;
}

/// A value that fits goes on one line.
std::string written(const Json& value, std::size_t indent, bool breaks = true) {
    if (!value.is_structured()) return value.dump();
    const bool is_object = value.is_object();
    const std::string separator = breaks ? ",\n" + std::string(indent + 2, ' ') : ", ";
    if (breaks) {
        std::string line = written(value, 0, false);
        if (indent + line.size() <= 140) return line;
    }
    std::string items;
    for (const auto& [key, item] : value.items()) {
        items += items.empty() ? "" : separator;
        items += (is_object ? Json(key).dump() + ": " : "") + written(item, indent + 2, breaks);
    }
    if (breaks) items = "\n" + std::string(indent + 2, ' ') + items + "\n" + std::string(indent, ' ');
    return (is_object ? "{" : "[") + items + (is_object ? "}" : "]");
}

}  // namespace

std::string with_methods(const std::string& schema, bool with_floating_horizon) {
    const Json methods = with_floating_horizon ? all_methods() : Json(method_names);
    const std::regex list(R"rx("method": *\{\s*"enum": *\[[^\]]*\]\s*\})rx");
    if (!std::regex_search(schema, list)) throw std::runtime_error("the schema has no list of methods");
    return std::regex_replace(schema, list, "\"method\": " + written({{"enum", methods}}, 8));
}

std::string with_event_schema(const std::string& schema) {
    Json document = Json::parse(schema);
    Json lines{reference("header"), reference("end")}, events;
    for (const auto& event : all_events()) {
        lines.push_back(reference("events/" + std::string(event.name)));
        events[std::string(event.name)] = schema_of(event);
    }
    document["oneOf"] = lines;
    Json& header = document["$defs"]["header"]["properties"];
    header["method"]["enum"] = all_methods();
    header["edition"] = {{"type", "string"}, {"pattern", edition_pattern(any_edition)}};
    document["$defs"]["header"]["then"]["properties"]["edition"] = {{"pattern", edition_pattern(edition_of_curves)}};
    header["kernel"]["pattern"] = kernel_pattern();
    header["detail"]["enum"] = detail_names;
    document["$defs"]["events"] = events;
    for (const auto& shape : named_words()) document["$defs"][std::string(shape.name)] = {{"enum", shape.words}};
    document["$defs"]["label"] = {{"type", "string"}, {"pattern", label_pattern()}};
    return written(document, 0) + "\n";
}

std::string with_failure_schema(const std::string& schema) {
    Json document = Json::parse(schema);
    Json& parts = document["$defs"];
    Json& run = parts["run"]["properties"];
    run["method"]["enum"] = all_methods();
    run["kernel"]["pattern"] = kernel_pattern();
    run["edition"]["pattern"] = edition_pattern(any_edition);
    parts["run_of_polygons"]["properties"]["method"]["enum"] = method_names;
    parts["run_of_curves"]["properties"]["method"]["const"] = floating_horizon_method;
    parts["run_of_curves"]["properties"]["edition"]["pattern"] = edition_pattern(edition_of_curves);
    parts["shows_of_polygons"]["properties"]["wrong"]["enum"] = procedure_names;
    parts["line"]["pattern"] = label_pattern();
    parts["words"]["required"] = language_codes;
    parts["words"]["properties"] = object_of<Json>(in_each_language([](Language) { return Json{{"type", "string"}}; }));
    return written(document, 0) + "\n";
}

}  // namespace vidno
