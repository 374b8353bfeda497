#include "format/tree_event.h"

#include <algorithm>
#include <limits>

#include "format/event_fields.h"

namespace vidno {

namespace {

int read_int(const JsonNode& node) {
    constexpr std::int64_t largest = std::numeric_limits<int>::max();
    const nlohmann::json& value = node.value();
    if (value.is_number_unsigned() && value.get<std::uint64_t>() <= std::uint64_t(largest)) return value.get<int>();
    if (value.is_number_integer() && !value.is_number_unsigned() && value.get<std::int64_t>() >= -largest) {
        return value.get<int>();
    }
    node.refuse("not a whole number, or too large");
}

/// Reads the fields of one event out of its object.
class FieldReader {
public:
    FieldReader(const JsonNode& object, const EventContext& context) : object_(object), context_(context) {}

    template <class E>
    E read() {
        E event;
        event.at = Line(member(object_, "at").place_among(line_names));
        fields_ = 2;  // e and at
        if (!E::lines.has(event.at)) object_.at("at").refuse("not a line of this event");
        E::fields(event, [&](std::string_view key, auto& target, const Meaning& meaning = any_number) {
            meaning_ = meaning;
            field(key, target);
        });
        if (object_.value().size() != fields_) object_.refuse("unknown key " + unknown_key(event));
        return event;
    }

private:
    template <class T>
    void field(std::string_view key, T& target) {
        value(member(object_, key), target);
        ++fields_;
    }
    template <class T>
    void field(std::string_view key, std::optional<T>& target) {
        if (object_.has(key)) field(key, target.emplace());
    }

    void value(const JsonNode& node, Value& target) const {
        // Rows are plain numbers under every kernel.
        const std::string text = node.is_text() ? node.text() : "";
        if (node.value().is_number()) {
            target.number = node.value().get<double>();
        } else if (text == "inf") {
            target = Value::infinite();
        } else if (text == "-inf") {
            target = Value::minus_infinite();
        } else if (text == "nan" && !context_.is_exact) {
            target.number = std::numeric_limits<double>::quiet_NaN();
        } else if (context_.is_exact && is_fraction(text)) {
            target = Value(text);
        } else {
            node.refuse("not a number of this kernel");
        }
    }
    void value(const JsonNode& node, int& target) const {
        target = read_int(node);
        if (!meaning_.has(target)) {
            node.refuse(meaning_.most == any_number.most
                            ? "less than " + std::to_string(meaning_.least)
                            : "not from " + std::to_string(meaning_.least) + " to " + std::to_string(meaning_.most));
        }
    }
    void value(const JsonNode& node, bool& target) const {
        if (!node.value().is_boolean()) node.refuse("not true or false");
        target = node.value().get<bool>();
    }
    void value(const JsonNode& node, double& target) const {
        if (!node.value().is_number()) node.refuse("not a number");
        target = node.value().get<double>();
    }
    void value(const JsonNode& node, std::string& target) const {
        if (!node.is_text()) node.refuse("not a string");
        target = node.text();
    }
    void value(const JsonNode& node, Fraction& target) const {
        if (node.is_null()) return;
        if (!node.is_text() || !is_fraction_or_none(node.text())) node.refuse("not a fraction");
        target.text = node.text();
    }
    void value(const JsonNode& node, Color& target) const {
        const auto color = node.is_text() ? color_of_hex(node.text()) : std::nullopt;
        if (!color) node.refuse("not a colour #rrggbb");
        target = *color;
    }
    void value(const JsonNode& node, PolygonPlace& target) const {
        Text name;
        if (node.is_text()) append_string(name, node.text());
        const auto place = context_.polygons.find(name.view());
        if (!place) node.refuse("not a polygon of the scene");
        target = *place;
    }
    void value(const JsonNode& node, Sign& target) const {
        const int sign = read_int(node);
        if (sign < -1 || sign > 1) node.refuse("not -1, 0 or 1");
        target = Sign{sign};
    }
    void value(const JsonNode& node, VisibilityFlag& target) const {
        const int flag = read_int(node);
        if (flag < -1 || flag > 2) node.refuse("not -1, 0, 1 or 2");
        target = VisibilityFlag(flag);
    }
    template <Word T>
    void value(const JsonNode& node, T& target) const {
        target = T(node.place_among(words_of(target)));
    }
    void value(const JsonNode& node, Answer& target) const {
        if (node.value().is_boolean()) {
            target = node.value().get<bool>();
        } else if (node.value().is_array()) {
            value(node, target.emplace<std::pair<int, int>>());
        } else {
            target = read_int(node);
        }
    }
    void value(const JsonNode& node, Truth& target) const {
        if (!node.is_null()) value(node, target.answer.emplace());
    }
    void value(const JsonNode& node, Listed auto& target) const {
        with_items(target, [&](auto&... items) {
            if (!node.value().is_array() || node.size() != sizeof...(items)) {
                node.refuse("not a list of " + std::to_string(sizeof...(items)));
            }
            std::size_t i = 0;
            (this->value(node.at(i++), items), ...);
        });
    }
    template <class T>
    void value(const JsonNode& node, std::vector<T>& target) const {
        if (!node.value().is_array()) node.refuse("not a list");
        for (std::size_t i = 0; i < node.size(); ++i) value(node.at(i), target.emplace_back());
    }

    template <class E>
    std::string unknown_key(const E& event) const {
        for (const auto& key : object_.keys()) {
            bool known = key == "e" || key == "at";
            E::fields(event, [&](std::string_view name, const auto&...) { known = known || name == key; });
            if (!known) return key;
        }
        return "";
    }

    const JsonNode& object_;
    const EventContext& context_;
    std::size_t fields_ = 0;
    Meaning meaning_;  // of the current field
};

template <class E>
Event read_as(const JsonNode& object, const EventContext& context) {
    if (E::kind.from > context.detail) object.at("e").refuse("an event above the trace's level of detail");
    return FieldReader(object, context).read<E>();
}

template <class... Events>
Event read_one_of(EventTypes<Events...>, std::size_t place, const JsonNode& object, const EventContext& context) {
    static constexpr std::array readers{&read_as<Events>...};
    return readers[place](object, context);
}

}  // namespace

nlohmann::json parse_line(std::string_view line) {
    try {
        return parse_json(line);
    } catch (const NotJson&) {
        throw Refused("not JSON");
    }
}

JsonNode member(const JsonNode& object, std::string_view key) {
    if (!object.has(key)) object.refuse("no key " + std::string(key));
    return object.at(key);
}

Event read_event(const JsonNode& object, const EventContext& context) {
    const JsonNode name = member(object, "e");
    const auto& names = AllEvents::names;
    const auto found = std::find(names.begin(), names.end(), name.text());
    if (found == names.end()) name.refuse("unknown event");
    return read_one_of(AllEvents{}, std::size_t(found - names.begin()), object, context);
}

}  // namespace vidno
