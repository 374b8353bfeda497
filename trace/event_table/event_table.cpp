#include "event_table/event_table.h"

#include <algorithm>
#include <iterator>

namespace vidno {

namespace {

template <class T>
struct Unwrapped {
    using type = T;
    static constexpr bool is_optional = false;
};
template <class T>
struct Unwrapped<std::optional<T>> {
    using type = T;
    static constexpr bool is_optional = true;
};

template <class E>
EventDescription description_of() {
    EventDescription event{E::kind.name, E::kind.from, E::lines, E::says, std::nullopt, std::nullopt, {}};
    if constexpr (requires { E::result_of; }) event.result_of = E::result_of;
    if constexpr (requires { E::decides; }) event.decides = E::decides;
    E example{};
    E::fields(example, [&]<class T>(std::string_view name, T&, const Meaning& meaning = any_number) {
        using Field = Unwrapped<T>;
        event.fields.push_back({name, ShapeOf<typename Field::type>::shape(), meaning, Field::is_optional});
    });
    return event;
}

template <class... Events>
EventGroup group_of(std::string_view title, EventTypes<Events...>) {
    return {title, {description_of<Events>()...}};
}

}  // namespace

std::vector<EventGroup> event_table() {
    return {group_of("Every method", EventsOfAll{}),
            group_of("Warnock", WarnockEvents{}),
            group_of("Z-buffer", ZBufferEvents{}),
            group_of("The Warnock family", FamilyEvents{}),
            group_of("Floating horizon", FloatingHorizonEvents{}),
            group_of("Weiler and Atherton's algorithm", WeilerAthertonEvents{})};
}

std::vector<EventDescription> all_events() {
    std::vector<EventDescription> all;
    for (auto& group : event_table()) std::ranges::move(group.events, std::back_inserter(all));
    return all;
}

std::vector<Procedure> called_procedures() {
    std::vector<Procedure> called;
    for (const auto& event : all_events()) {
        if (event.result_of) called.push_back(*event.result_of);
    }
    std::sort(called.begin(), called.end());
    called.erase(std::unique(called.begin(), called.end()), called.end());
    return called;
}

std::vector<Shape> named_words() {
    std::vector<Shape> all;
    for (const auto& event : all_events()) {
        for (const auto& field : event.fields) {
            // A list of words takes its name from its items.
            const Shape& shape = field.shape.kind == Shape::Kind::list ? field.shape.items.front() : field.shape;
            const bool is_known = std::ranges::count(all, shape.name, &Shape::name) > 0;
            if (shape.kind == Shape::Kind::words && !shape.name.empty() && !is_known) all.push_back(shape);
        }
    }
    for (auto& shape : all) {
        if (shape.name != shape_name<Procedure>) continue;
        shape.words.clear();
        for (const Procedure procedure : called_procedures()) {
            shape.words.push_back(procedure_names[std::size_t(procedure)]);
        }
    }
    return all;
}

std::vector<DerivedDocument> derived_documents() {
    return {{"FORMAT.md", with_format_tables},
            {"schema/trace.schema.json", with_event_schema},
            {"schema/failure.schema.json", with_failure_schema},
            {"schema/chart.schema.json", [](const std::string& text) { return with_methods(text, false); }},
            {"schema/lesson.schema.json", [](const std::string& text) { return with_methods(text, true); }}};
}

std::vector<std::string_view> names_of(const LineSet& lines) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < line_names.size(); ++i) {
        if (lines.has(Line(i))) names.push_back(line_names[i]);
    }
    return names;
}

std::vector<std::string_view> line_letters() {
    std::vector<std::string_view> letters;
    for (const auto name : line_names) {
        const auto own = name.substr(0, name.find_first_of("123456789"));
        if (letters.empty() || letters.back() != own) letters.push_back(own);
    }
    return letters;
}

}  // namespace vidno
