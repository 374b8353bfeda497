// The page's table of events.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "event_table/event_table.h"
#include "event_table/joined_texts.h"
#include "format/decision_words.h"

namespace vidno {

namespace {

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string check(const Shape& shape, const Meaning& meaning) {
    const auto inner = [&meaning](const Shape& item) { return check(item, meaning); };
    if (!shape.name.empty()) return (shape.kind == Shape::Kind::words ? "" : "is.") + std::string(shape.name);
    switch (shape.kind) {
        case Shape::Kind::named: break;
        case Shape::Kind::words: return "is.oneOf(" + joined_texts(shape.words, ", ", in_quotes) + ")";
        case Shape::Kind::numbers:
            return "is.oneOf(" + joined_texts(shape.numbers, ", ", [](int n) { return std::to_string(n); }) + ")";
        case Shape::Kind::tuple: return "is.tuple(" + joined_texts(shape.items, ", ", inner) + ")";
        case Shape::Kind::list: return "is.list(" + inner(shape.items.front()) + ")";
        case Shape::Kind::integer: break;
    }
    if (meaning.most != any_number.most) {
        return "is.between(" + std::to_string(meaning.least) + ", " + std::to_string(meaning.most) + ")";
    }
    return meaning.least == any_number.least ? "is.whole" : "is.count";
}

std::string field(const FieldDescription& field) {
    const std::string type = check(field.shape, field.meaning);
    return "      " + std::string(field.name) + ": " + (field.is_optional ? "is.optional(" + type + ")" : type) + ",\n";
}

std::string kind(const EventDescription& event) {
    const bool at_any = event.lines == LineSet::all();
    std::string text = "  " + std::string(event.name) + ": {\n";
    text += "    at: " + (at_any ? "label" : "is.oneOf(" + joined_texts(names_of(event.lines), ", ", in_quotes) + ")") +
            ",\n";
    text += "    from: " + in_quotes(detail_names[std::size_t(event.from)]) + ",\n";
    text += "    fields: {\n";
    for (const auto& each : event.fields) text += field(each);
    text += "    },\n";
    if (event.result_of) text += "    resultOf: " + in_quotes(procedure_names[std::size_t(*event.result_of)]) + ",\n";
    if (event.decides) text += "    decides: " + in_quotes(decision_names[std::size_t(*event.decides)]) + ",\n";
    return text + "  },\n";
}

/// The labels of a method's lines.
std::vector<std::string> labels_of(const nlohmann::json& listings, const nlohmann::json& names) {
    std::vector<std::string> labels;
    for (const auto& procedure : listings.at("procedures")) {
        if (std::find(names.begin(), names.end(), procedure.at("name")) == names.end()) continue;
        for (const auto& line : procedure.at("lines")) labels.push_back(line.at("at"));
    }
    return labels;
}

}  // namespace

std::string event_types(const std::string& listings_text) {
    const auto events = all_events();

    std::string text =
        "// Made by vidno_event_table of trace/format/event.h: change that.\n\nimport * as is from './values.js';\n\n";
    for (const auto& [kind, name, words, numbers, items] : named_words()) {
        const std::string own(name);
        text += "export const " + own + "s = [" + joined_texts(words, ", ", in_quotes) + "] as const;\n";
        text += "const " + own + " = is.oneOf(..." + own + "s);\n";
    }
    text += "\n/** What a decision is about, for the middle of a sentence. */\nexport const decisionWords = {\n";
    for (const Language language : languages) {
        text += "  " + std::string(code_of(language)) + ": {\n";
        for (std::size_t i = 0; i < decision_names.size(); ++i) {
            text += "    " + std::string(decision_names[i]) + ": " + in_quotes(decision_words[i].in(language)) + ",\n";
        }
        text += "  },\n";
    }
    text += "} as const;\n";
    text += "\n/** The level from which the calls of a procedure appear. */\nexport const callsFrom = {\n";
    for (const Procedure procedure : called_procedures()) {
        text += "  " + std::string(procedure_names[std::size_t(procedure)]) + ": " +
                in_quotes(detail_names[std::size_t(event::calls_from(procedure))]) + ",\n";
    }
    text += "} as const;\n\n";
    text += "const label = is.label([" + joined_texts(line_letters(), ", ", in_quotes) + "]);\n\n";
    text += "/** For each event: its lines, the level from which it appears, and its fields. */\n";
    text += "export const kinds = {\n";
    for (const auto& event : events) text += kind(event);
    text += "} as const;\n\n/** The events in the runs of each method. */\nexport const eventsOf = {\n";
    const auto listings = nlohmann::ordered_json::parse(listings_text);
    for (const auto& [method, names] : listings.at("methods").items()) {
        const auto labels = labels_of(listings, names);
        std::vector<std::string_view> told;
        for (const auto& event : events) {
            const auto lines = names_of(event.lines);
            if (std::ranges::find_first_of(lines, labels) != lines.end()) told.push_back(event.name);
        }
        text += "  " + in_quotes(method) + ": [" + joined_texts(told, ", ", in_quotes) + "],\n";
    }
    return text + "} as const;\n";
}

}  // namespace vidno
