#include <array>
#include <concepts>
#include <ranges>

#include "json/json_text.h"
#include "margin/margin.h"

namespace vidno {

namespace {

std::string_view name_of(Procedure of) { return procedure_names[std::size_t(of)]; }
std::string_view name_of(Line of) { return line_names[std::size_t(of)]; }
std::string_view name_of(PolygonPlace of, const Scene& scene) { return scene.polygons[std::size_t(of.index)].id; }

// ------------------------------------------------------------------------------------- as text

/// A fraction as usually written: 3 for 3/1.
std::string plain(const std::string& fraction) {
    return fraction.ends_with("/1") ? fraction.substr(0, fraction.size() - 2) : fraction;
}

std::string text_of(const Value& value) {
    if (value.fraction) return plain(*value.fraction);
    Text text;
    append_number(text, value.number);
    return text.string();
}

std::string text_of(const Value& x, const Value& y) { return "(" + text_of(x) + ", " + text_of(y) + ")"; }

/// "x - 9 y + 1/2"
std::string text_of(const std::array<Fraction, 3>& line) {
    constexpr std::array<std::string_view, 3> variables{"x", "y", ""};
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        std::string number = plain(line[i].text);
        if (number == "0") continue;
        const bool is_negative = number.front() == '-';
        if (is_negative) number.erase(0, 1);
        if (text.empty()) {
            text += is_negative ? "-" : "";
        } else {
            text += is_negative ? " - " : " + ";
        }
        const std::string_view variable = variables[i];
        if (variable.empty() || number != "1") text += number;
        if (!variable.empty()) text += (number == "1" ? "" : " ") + std::string(variable);
    }
    return text;
}

std::string half_plane(const MarginSide& side) {
    constexpr std::array<std::string_view, 3> relations{" < 0", " = 0", " > 0"};
    return text_of(side.line) + std::string(relations[place_of(side.sign)]);
}

/// The sides of a window, in the order of PolygonClip.
std::string_view side_name(int side) {
    constexpr std::array<std::string_view, 4> names{"top", "left", "bottom", "right"};
    return names[std::size_t(side - 1)];
}

/// What happens on the line at which the sign changes: "edge 1 of A passes over (0, 0)".
std::string happening(const StepSign& sign, const Scene& scene) {
    const std::string of_polygon = " of " + std::string(name_of(sign.polygon, scene)) + " passes over ";
    if (sign.vertex) {
        return "vertex " + std::to_string(*sign.vertex) + of_polygon + "the " + std::string(side_name(*sign.side)) +
               " side of the window";
    }
    const std::string edge = "edge " + std::to_string(*sign.edge) + of_polygon;
    if (sign.point) return edge + text_of(sign.point->x, sign.point->y);
    const std::string_view one = side_name(*sign.cut), other = side_name(*sign.side);
    return edge + "the corner of the " + std::string(one) + " and " + std::string(other) + " sides";
}

std::string text_of(const StepSign& sign, const Scene& scene) {
    constexpr std::array<std::string_view, 3> words{"negative", "zero", "positive"};
    std::string text = happening(sign, scene) + ": the sign at step " + std::to_string(sign.step) + ", " +
                       std::string(name_of(sign.at)) + ", is " + std::string(words[place_of(sign.sign)]);
    if (sign.in_run != sign.sign) text += " and computed as " + std::string(words[place_of(sign.in_run)]);
    return text;
}

// ------------------------------------------------------------------------------------- as JSON

void append(Text& out, std::string_view text) { append_string(out, text); }
void append(Text& out, std::integral auto number) { append_integer(out, number); }
void append(Text& out, bool truth) { out += truth ? "true" : "false"; }
void append(Text& out, Sign sign) { append_integer(out, int(sign)); }
void append(Text& out, const Value& value) {
    value.fraction ? append_string(out, *value.fraction) : append_number(out, value.number);
}

/// Appends a comma before an item or a member, except the first.
void separate(Text& out) {
    const char last = out.view().back();
    if (last != '{' && last != '[') out += ',';
}

template <class T>
void append_member(Text& out, std::string_view key, const T& value) {
    separate(out);
    append_string(out, key);
    out += ':';
    append(out, value);
}
template <class T>
void append_member(Text& out, std::string_view key, const std::optional<T>& value) {
    if (value) append_member(out, key, *value);
}

/// A member that is a list; `append_item(item)` writes each.
void append_list(Text& out, std::string_view key, const std::ranges::range auto& items, auto&& append_item) {
    separate(out);
    append_string(out, key);
    out += ":[";
    for (const auto& item : items) {
        separate(out);
        append_item(item);
    }
    out += ']';
}

void append_point(Text& out, std::string_view key, const Value& x, const Value& y) {
    append_list(out, key, std::array{x, y}, [&](const Value& coordinate) { append(out, coordinate); });
}

void append_sign(Text& out, const StepSign& sign, const Scene& scene) {
    out += '{';
    append_member(out, "step", sign.step);
    append_member(out, "at", name_of(sign.at));
    append_member(out, "polygon", name_of(sign.polygon, scene));
    append_member(out, "vertex", sign.vertex);
    append_member(out, "edge", sign.edge);
    if (sign.point) append_point(out, "point", sign.point->x, sign.point->y);
    append_member(out, "cut", sign.cut);
    append_member(out, "side", sign.side);
    append_member(out, "sign", sign.sign);
    append_member(out, "told", sign.in_run);
    out += '}';
}

void append_side(Text& out, const MarginSide& side, const Scene& scene) {
    out += '{';
    append_member(out, "a", side.line[0].text);
    append_member(out, "b", side.line[1].text);
    append_member(out, "c", side.line[2].text);
    append_member(out, "sign", side.sign);
    append_member(out, "bounds", side.bounds);
    append_list(out, "flips", side.flips, [&](const StepSign& sign) { append_sign(out, sign, scene); });
    out += '}';
}

}  // namespace

std::string margin_text(const Margin& margin, const Scene& scene) {
    std::string text = "step " + std::to_string(margin.step) + ", " + std::string(name_of(margin.procedure)) +
                       ", vertex " + std::string(name_of(margin.polygon, scene)) + "." + std::to_string(margin.vertex) +
                       " at " + text_of(margin.at.x, margin.at.y) + "\n";
    if (margin.sides.empty()) return text + "no sign of this step depends on the vertex\n";
    text += "no sign changes while\n";
    for (const auto& side : margin.sides) {
        text += "  " + half_plane(side) + (side.bounds ? "" : "   (follows from the others)") + "\n";
        for (const auto& sign : side.flips) text += "      " + text_of(sign, scene) + "\n";
    }
    return text;
}

std::string margin_json(const Margin& margin, const Scene& scene) {
    Text out;
    out += '{';
    append_member(out, "format", std::string_view("vidno-margin/1"));
    append_member(out, "step", margin.step);
    append_member(out, "procedure", name_of(margin.procedure));
    append_member(out, "polygon", name_of(margin.polygon, scene));
    append_member(out, "vertex", margin.vertex);
    append_point(out, "at", margin.at.x, margin.at.y);
    append_list(out, "sides", margin.sides, [&](const MarginSide& side) { append_side(out, side, scene); });
    out += "}\n";
    return out.string();
}

}  // namespace vidno
