#include <utility>

#include "json/json_text.h"
#include "margin/margin.h"

namespace vidno {

namespace {

/// Negative, zero, positive.
std::size_t place_of(Sign sign) {
    const int place = int(sign) + 1;
    return std::size_t(place);
}

/// A fraction as one writes it: 3 for 3/1.
std::string plain(const Fraction& fraction) {
    return fraction.text.ends_with("/1") ? fraction.text.substr(0, fraction.text.size() - 2) : fraction.text;
}

std::string expression(const MarginSide& side) {
    std::string text;
    constexpr std::array<std::string_view, 3> variables{"x", "y", ""};
    for (std::size_t i = 0; i < variables.size(); ++i) {
        std::string number = plain(side.line[i]);
        if (number == "0") continue;
        const bool is_negative = number.front() == '-';
        if (is_negative) number.erase(0, 1);
        text += text.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
        if (number != "1" || variables[i].empty()) text += number + (variables[i].empty() ? "" : " ");
        text += variables[i];
    }
    constexpr std::array<std::string_view, 3> relations{" < 0", " = 0", " > 0"};
    return text + std::string(relations[place_of(side.sign)]);
}

std::string_view sign_text(Sign sign) {
    constexpr std::array<std::string_view, 3> words{"negative", "zero", "positive"};
    return words[place_of(sign)];
}

std::string number_text(const Value& value) {
    if (value.fraction) return plain({*value.fraction});
    Text text;
    append_number(text, value.number);
    return text.string();
}

std::string what(const StepSign& sign, const Scene& scene) {
    const std::string polygon = scene.polygons[std::size_t(sign.polygon.index)].id;
    const auto number = [](int of) { return std::to_string(of); };
    if (sign.point) {
        return "edge " + number(*sign.edge) + " of " + polygon + " and (" + number_text(sign.point->x) + ", " +
               number_text(sign.point->y) + ")";
    }
    const std::string side = " and side " + number(*sign.side);
    if (sign.vertex) return "vertex " + number(*sign.vertex) + " of " + polygon + side;
    return "the cut of edge " + number(*sign.edge) + " of " + polygon + " at side " + number(*sign.cut) + side;
}

void append(Text& out, std::string_view key, std::optional<int> value) {
    if (!value) return;
    out += ",\"";
    out += key;
    out += "\":";
    append_integer(out, *value);
}
void append(Text& out, const Value& value) {
    value.fraction ? append_string(out, *value.fraction) : append_number(out, value.number);
}

void append(Text& out, const StepSign& sign, const Scene& scene) {
    out += "{\"step\":";
    append_integer(out, sign.step);
    out += ",\"at\":";
    append_string(out, line_names[std::size_t(sign.at)]);
    out += ",\"polygon\":";
    append_string(out, scene.polygons[std::size_t(sign.polygon.index)].id);
    append(out, "vertex", sign.vertex);
    append(out, "edge", sign.edge);
    if (sign.point) {
        out += ",\"point\":[";
        append(out, sign.point->x);
        out += ',';
        append(out, sign.point->y);
        out += ']';
    }
    append(out, "cut", sign.cut);
    append(out, "side", sign.side);
    append(out, "sign", int(sign.sign));
    append(out, "told", int(sign.told));
    out += '}';
}

void append(Text& out, const MarginSide& side, const Scene& scene) {
    out += "{\"a\":";
    append_string(out, side.line[0].text);
    out += ",\"b\":";
    append_string(out, side.line[1].text);
    out += ",\"c\":";
    append_string(out, side.line[2].text);
    append(out, "sign", int(side.sign));
    out += ",\"bounds\":";
    out += side.bounds ? "true" : "false";
    out += ",\"flips\":[";
    bool first = true;
    for (const auto& each : side.flips) {
        if (!std::exchange(first, false)) out += ',';
        append(out, each, scene);
    }
    out += "]}";
}

std::string vertex_name(const Margin& margin, const Scene& scene) {
    return scene.polygons[std::size_t(margin.polygon.index)].id + '.' + std::to_string(margin.vertex);
}

}  // namespace

std::string margin_text(const Margin& margin, const Scene& scene) {
    std::string text = "step " + std::to_string(margin.step) + ", " +
                       std::string(procedure_names[std::size_t(margin.procedure)]) + ", vertex " +
                       vertex_name(margin, scene) + " at (" + number_text(margin.at.x) + ", " +
                       number_text(margin.at.y) + ")\n";
    if (margin.sides.empty()) return text + "no sign of this step depends on it\n";
    for (const auto& side : margin.sides) {
        text += "  " + expression(side) + (side.bounds ? "" : "  (implied by the others)") + '\n';
        for (const auto& sign : side.flips) {
            text += "      step " + std::to_string(sign.step) + ", " + std::string(line_names[std::size_t(sign.at)]) +
                    ": " + what(sign, scene) + ", " + std::string(sign_text(sign.sign));
            if (sign.told != sign.sign) text += ", computed as " + std::string(sign_text(sign.told));
            text += '\n';
        }
    }
    return text;
}

std::string margin_json(const Margin& margin, const Scene& scene) {
    Text out;
    out += "{\"format\":\"vidno-margin/1\",\"step\":";
    append_integer(out, margin.step);
    out += ",\"procedure\":";
    append_string(out, procedure_names[std::size_t(margin.procedure)]);
    out += ",\"polygon\":";
    append_string(out, scene.polygons[std::size_t(margin.polygon.index)].id);
    append(out, "vertex", margin.vertex);
    out += ",\"at\":[";
    append_number(out, margin.at.x);
    out += ',';
    append_number(out, margin.at.y);
    out += "],\"sides\":[";
    bool first = true;
    for (const auto& side : margin.sides) {
        if (!std::exchange(first, false)) out += ',';
        append(out, side, scene);
    }
    out += "]}\n";
    return out.string();
}

}  // namespace vidno
