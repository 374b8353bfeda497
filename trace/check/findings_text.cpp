#include "check/findings_text.h"

#include <utility>

#include "json/json_text.h"

namespace vidno {

namespace {

std::string_view name_of(FindingKind kind) { return finding_kind_names[std::size_t(kind)]; }
std::string_view name_of(Decision of) { return decision_names[std::size_t(of)]; }
std::string_view name_of(Coincidence of) { return coincidence_names[std::size_t(of)]; }
std::string_view name_of(Cause of) { return cause_names[std::size_t(of)]; }
std::string_view name_of(Procedure of) { return procedure_names[std::size_t(of)]; }
std::string_view name_of(Line of) { return line_names[std::size_t(of)]; }

void append(Text& out, const Answer& answer) {
    std::visit(
        [&]<class A>(const A& it) {
            if constexpr (std::same_as<A, bool>) {
                out += it ? "true" : "false";
            } else if constexpr (std::same_as<A, int>) {
                append_integer(out, it);
            } else {
                out += '[';
                append_integer(out, it.first);
                out += ',';
                append_integer(out, it.second);
                out += ']';
            }
        },
        answer);
}

void append(Text& out, double number) { append_number(out, number); }
void append(Text& out, std::string_view text) { append_string(out, text); }
void append(Text& out, const Fraction& fraction) {
    fraction.text.empty() ? void(out += "null") : append_string(out, fraction.text);
}
void append(Text& out, const Value& value) {
    value.fraction ? append_string(out, *value.fraction) : append_number(out, value.number);
}
void append(Text& out, const PixelRectangle& pixels) {
    out += '[';
    append_integer(out, pixels.x);
    for (const int each : {pixels.y, pixels.width, pixels.height}) {
        out += ',';
        append_integer(out, each);
    }
    out += ']';
}
void append(Text& out, const Operand& operand) {
    out += '[';
    append_string(out, operand.name);
    out += ',';
    append(out, operand.used);
    out += ',';
    append(out, operand.exact);
    out += ']';
}
template <class T>
void append(Text& out, const std::vector<T>& items) {
    out += '[';
    bool first = true;
    for (const auto& item : items) {
        if (!std::exchange(first, false)) out += ',';
        append(out, item);
    }
    out += ']';
}

std::vector<std::string_view> polygons_of(const FindingsHeader& header, const Finding& finding) {
    std::vector<std::string_view> ids;
    for (const auto& [index] : finding.polygons) ids.push_back(header.polygons[std::size_t(index)]);
    return ids;
}

/// Calls `field(key, value)` for each that the finding has.
void for_each_field(const FindingsHeader& header, const Finding& finding, auto&& field) {
    const JudgedDecision& decision = finding.decision;
    field("kind", name_of(finding.kind));
    // Steps are whole numbers that a double holds.
    field("step", double(finding.step));
    if (!finding.is_shown) field("isShown", Answer(false));
    field("at", name_of(finding.at));
    field("procedure", name_of(finding.procedure));
    field("polygons", polygons_of(header, finding));
    field("pixels", finding.pixels);
    if (finding.kind == FindingKind::point) {
        field("off", finding.off);
    } else {
        field("of", name_of(decision.of));
        field("taken", decision.taken);
        if (decision.truth.answer) field("exact", *decision.truth.answer);
        if (finding.kind == FindingKind::wrong) field("cause", name_of(decision.cause()));
    }
    if (const auto& gap = finding.gap) {
        field("coincidence", name_of(gap->if_zero));
        field("computed", gap->computed);
        field("gap", gap->exact);
        field("sign", double(int(gap->sign)));
        field("ulps", gap->ulps);
    }
    field("operands", decision.operands);
}

constexpr std::array<std::string_view, 16> column_names{
    "kind",  "step",  "at",          "procedure", "of",  "polygons", "pixels", "taken",
    "exact", "cause", "coincidence", "computed",  "gap", "sign",     "ulps",   "off"};

/// In quotes where the format requires them.
void append_cell(Text& out, std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos) {
        out += text;
        return;
    }
    out += '"';
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    out += '"';
}

/// As plain text, for a cell.
std::string plain(std::string_view text) { return std::string(text); }
std::string plain(const std::vector<std::string_view>& items) {
    std::string all;
    for (const auto item : items) all += (all.empty() ? "" : " ") + std::string(item);
    return all;
}
std::string plain(const Fraction& fraction) { return fraction.text; }
std::string plain(const Value& value) {
    if (value.fraction) return *value.fraction;
    Text text;
    append_number(text, value.number);
    std::string number = text.string();
    std::erase(number, '"');
    return number;
}
std::string plain(double value) { return plain(Value(value)); }
std::string plain(const Answer& answer) {
    Text text;
    append(text, answer);
    return text.string();
}
std::string plain(const PixelRectangle& pixels) {
    Text text;
    append(text, pixels);
    return text.string();
}
std::string plain(const Operands& operands) {
    std::string all;
    for (const auto& [name, used, exact] : operands) {
        all += (all.empty() ? "" : "; ") + name + " = " + used.text;
        if (exact != used) all += " (" + (exact.text.empty() ? "undefined" : exact.text) + ")";
    }
    return all;
}

}  // namespace

FindingsHeader findings_header(const RunRequest& request) {
    FindingsHeader header{method_names[std::size_t(request.method)],
                          name_of(request.edition),
                          request.kernel.name(),
                          request.scene->name,
                          {}};
    for (const auto& polygon : request.scene->polygons) header.polygons.push_back(polygon.id);
    return header;
}
FindingsHeader findings_header(const FloatingHorizonRequest& request, const std::string& name) {
    return {floating_horizon_method, name_of(request.edition), request.kernel.name(), name, {}};
}

std::string findings_jsonl(const FindingsHeader& header, const std::vector<Finding>& findings) {
    Text out;
    out += R"({"format":"vidno-decisions/1","method":)";
    append_string(out, header.method);
    out += R"(,"edition":)";
    append_string(out, header.edition);
    out += R"(,"kernel":)";
    append_string(out, header.kernel);
    out += R"(,"scene":)";
    append_string(out, header.scene);
    out += "}\n";
    for (const auto& finding : findings) {
        bool first = true;
        for_each_field(header, finding, [&](std::string_view key, const auto& value) {
            out += std::exchange(first, false) ? "{\"" : ",\"";
            out += key;
            out += "\":";
            append(out, value);
        });
        out += "}\n";
    }
    return out.string();
}

std::string findings_csv(const FindingsHeader& header, const std::vector<Finding>& findings) {
    Text out;
    for (const auto column : column_names) {
        out += column;
        out += ',';
    }
    out += "operands\n";
    for (const auto& finding : findings) {
        std::array<std::string, column_names.size()> cells;
        std::string operands;
        for_each_field(header, finding, [&](std::string_view key, const auto& value) {
            const auto column = std::find(column_names.begin(), column_names.end(), key);
            (column == column_names.end() ? operands : cells[std::size_t(column - column_names.begin())]) =
                plain(value);
        });
        for (const auto& cell : cells) {
            append_cell(out, cell);
            out += ',';
        }
        append_cell(out, operands);
        out += '\n';
    }
    return out.string();
}

}  // namespace vidno
