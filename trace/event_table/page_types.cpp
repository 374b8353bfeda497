// The page's types of events and values.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "event_table/event_table.h"
#include "event_table/joined_texts.h"
#include "format/decision_words.h"
#include "format/field_writer.h"
#include "replay/floating_horizon_state.h"
#include "replay/state.h"
#include "say/decision.h"

namespace vidno {

namespace {

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

std::string one_of(const auto& words) { return joined_texts(words, " | ", in_quotes); }

/// The TypeScript of a C++ type, and whether its values have numbers of the kernel.
template <class T>
struct PageType {
    static constexpr bool has_numbers = false;
    static std::string name() {
        if constexpr (std::same_as<T, bool>) return "boolean";
        if constexpr (std::same_as<T, int> || std::same_as<T, double>) return "number";
        if constexpr (std::same_as<T, std::string> || std::same_as<T, PolygonPlace> || std::same_as<T, Color>) {
            return "string";
        }
        if constexpr (std::same_as<T, Sign>) return "-1 | 0 | 1";
        if constexpr (std::same_as<T, VisibilityFlag>) return "-1 | 0 | 1 | 2";
        if constexpr (std::same_as<T, Line>) return "string";
        if constexpr (std::same_as<T, Event>) return "Event";
        if constexpr (std::same_as<T, Answer>) return "boolean | number | readonly [number, number]";
        if constexpr (std::same_as<T, Truth>) return PageType<Answer>::name() + " | null";
        if constexpr (Word<T>) return shape_name<T>.empty() ? one_of(words_of(T{})) : capital(shape_name<T>);
        return "";
    }
    static std::string capital(std::string_view word) {
        std::string text(word);
        text[0] = char(text[0] - 'a' + 'A');
        return text;
    }
};
template <>
struct PageType<Value> {
    static constexpr bool has_numbers = true;
    static std::string name() { return "N"; }
};
template <>
struct PageType<Fraction> {
    static constexpr bool has_numbers = true;
    static std::string name() { return "string | null"; }
};
/// Types of values.ts.
template <class T>
concept NamedOnPage = std::same_as<T, Window> || std::same_as<T, ValuePoint> || std::same_as<T, ValueVertex> ||
    std::same_as<T, RegionLoops> || std::same_as<T, PolygonPart>;
template <class T>
struct PageType<std::optional<T>> {
    static constexpr bool has_numbers = PageType<T>::has_numbers;
    static std::string name() { return PageType<T>::name() + " | null"; }
};
template <class T>
struct PageType<std::shared_ptr<const T>> : PageType<T> {};
template <NamedOnPage T>
struct PageType<T> {
    static constexpr bool has_numbers = !std::same_as<T, Window>;
    static std::string name() {
        if (std::same_as<T, Window>) return "Box";
        if (std::same_as<T, ValuePoint>) return "Point";
        if (std::same_as<T, ValueVertex>) return "Vertex";
        return std::same_as<T, PolygonPart> ? "Piece" : "Region";
    }
};
template <class T>
requires(!NamedOnPage<std::vector<T>>) struct PageType<std::vector<T>> {
    static constexpr bool has_numbers = PageType<T>::has_numbers;
    static std::string name() {
        const std::string item = PageType<T>::name();
        return "readonly " + (item.find(' ') == item.npos ? item : "(" + item + ")") + "[]";
    }
};
template <Listed T>
requires(!NamedOnPage<T>) struct PageType<T> {
    static constexpr bool has_numbers = decltype(with_items(std::declval<T&>(), []<class... Items>(const Items&...) {
        return std::bool_constant<(PageType<Items>::has_numbers || ...)>{};
    }))::value;
    static std::string name() {
        T value{};
        return with_items(value, []<class... Items>(const Items&...) {
            return "readonly [" + joined_texts(std::array{PageType<Items>::name()...}, ", ", std::identity{}) + "]";
        });
    }
};
template <Fielded T>
struct PageType<T> {
    static constexpr bool has_numbers = false;
    static std::string name() {
        const T example{};
        return object(example, " ");
    }

    /// The fields of an example.
    static std::string object(const T& example, const std::string& between) {
        std::string text = "{" + between;
        T::fields(example, [&]<class Field>(std::string_view key, const Field&) {
            text += "readonly " + std::string(key) + ": " + PageType<Field>::name() + ";" + between;
        });
        return text + "}";
    }
};

template <class T>
std::string interface_of(std::string_view name, const T& example) {
    return "\nexport interface " + std::string(name) + " " + PageType<T>::object(example, "\n") + "\n";
}

template <class E>
std::string event_type() {
    std::string text = "  readonly " + std::string(E::kind.name) + ": {\n    readonly e: " + in_quotes(E::kind.name) +
                       ";\n    readonly at: " + (E::lines == LineSet::all() ? "string" : one_of(names_of(E::lines))) +
                       ";\n";
    const E example{};
    E::fields(example, [&]<class Field>(std::string_view key, const Field&, const auto&...) {
        text += "    readonly " + std::string(key);
        if constexpr (requires(Field field) { field.has_value(); }) {
            text += "?: " + PageType<typename Field::value_type>::name();
        } else {
            text += ": " + PageType<Field>::name();
        }
        text += ";\n";
    });
    return text + "  };\n";
}

template <class E>
std::string kind() {
    std::vector<std::string_view> fields, numbers;
    const E example{};
    E::fields(example, [&]<class Field>(std::string_view key, const Field&, const auto&...) {
        fields.push_back(key);
        if (PageType<Field>::has_numbers) numbers.push_back(key);
    });
    const auto list = [](const auto& words) { return "[" + joined_texts(words, ", ", in_quotes) + "]"; };
    std::string text = "  " + std::string(E::kind.name) +
                       ": {\n    at: " + (E::lines == LineSet::all() ? "null" : list(names_of(E::lines))) +
                       ",\n    from: " + in_quotes(detail_names[std::size_t(E::kind.from)]) +
                       ",\n    fields: " + list(fields) + ",\n    numbers: " + list(numbers) + ",\n";
    if constexpr (requires { E::result_of; }) {
        text += "    resultOf: " + in_quotes(procedure_names[std::size_t(E::result_of)]) + ",\n";
    }
    return text + "  },\n";
}

template <class... Events>
std::string for_events(EventTypes<Events...>, auto&& text) {
    return (text.template operator()<Events>() + ...);
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

/// A constant of the page: words by language and name.
std::string words_by_name(const std::string& constant, const auto& names, const auto& words) {
    std::string text = "export const " + constant + " = {\n";
    for (const Language language : languages) {
        text += "  " + std::string(code_of(language)) + ": {\n";
        for (std::size_t i = 0; i < names.size(); ++i) {
            text += "    " + std::string(names[i]) + ": " + in_quotes(words[i].in(language)) + ",\n";
        }
        text += "  },\n";
    }
    return text + "} as const;\n";
}

std::string words_of_decisions() {
    return "\n/** What a decision is about, for the middle of a sentence. */\n" +
           words_by_name("decisionWords", decision_names, decision_words) + "\n/** Why a decision is wrong. */\n" +
           words_by_name("causeWords", cause_names, cause_words);
}

std::string events_of_methods(const std::string& listings_text) {
    std::string text = "\n/** The events in the runs of each method. */\nexport const eventsOf = {\n";
    const auto listings = nlohmann::ordered_json::parse(listings_text);
    const auto events = all_events();
    for (const auto& [method, names] : listings.at("methods").items()) {
        const auto labels = labels_of(listings, names);
        std::vector<std::string_view> own;
        for (const auto& event : events) {
            const auto lines = names_of(event.lines);
            if (std::ranges::find_first_of(lines, labels) != lines.end()) own.push_back(event.name);
        }
        text += "  " + in_quotes(method) + ": [" + joined_texts(own, ", ", in_quotes) + "],\n";
    }
    return text + "} as const;\n";
}

}  // namespace

std::string page_types(const std::string& listings) {
    std::string text =
        "// Made by vidno_event_table of trace/format/event.h and of the states in trace/replay: change those.\n\n"
        "import type { Event } from './events.js';\n"
        "import type { Box, Piece, Point, Region, Vertex } from './values.js';\n\n"
        "/** A number of the run's kernel. The page copies it and never computes with it. */\n"
        "export type N = number | string;\n\n";
    for (const auto& [kind, name, words, numbers, items] : named_words()) {
        const std::string own(name);
        text += "export const " + own + "s = [" + joined_texts(words, ", ", in_quotes) + "] as const;\n";
        text += "export type " + PageType<int>::capital(own) + " = (typeof " + own + "s)[number];\n";
    }
    text += words_of_decisions();
    text += "\n/** The level from which the calls of a procedure appear. */\nexport const callsFrom = {\n";
    for (const Procedure procedure : called_procedures()) {
        text += "  " + std::string(procedure_names[std::size_t(procedure)]) + ": " +
                in_quotes(detail_names[std::size_t(event::calls_from(procedure))]) + ",\n";
    }
    text += "} as const;\n\nexport interface Events {\n";
    text += for_events(AllEvents{}, []<class E> { return event_type<E>(); });
    text +=
        "}\n\n/** For each event: its lines, null for all; the level from which it appears; its fields, and those with "
        "numbers. */\n";
    text += "export const kinds = {\n" + for_events(AllEvents{}, []<class E> { return kind<E>(); }) + "} as const;\n";
    text += events_of_methods(listings);
    text +=
        "\n/** A running procedure, and its line. The first one is that of the method. */\n"
        "export interface Frame {\nreadonly of: string;\nreadonly at: string | null;\n}\n";
    const TraceHeader header;
    return text + interface_of("WarnockValues", WarnockState(header)) +
           interface_of("ZBufferValues", ZBufferState(header)) +
           interface_of("WeilerAthertonValues", WeilerAthertonState(header)) +
           interface_of("FloatingHorizonValues", FloatingHorizonState::Values{}) +
           "\n/** The decision of a step in words. */" + interface_of("SaidDecision", say::SaidDecision{});
}

}  // namespace vidno
