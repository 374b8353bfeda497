#include "grade/table.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "characters.h"
#include "refused.h"

namespace vidno {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view heading =
    "program,verdict,scenes,wrong,scene,step,at,program says,but,mistake,told,not told,faults\n";
constexpr std::string_view said_right = "right", said_wrong = "wrong", not_judged = "not judged";

std::string name_of(Deviation deviation) {
    const DeviationChoice& choice = choice_of(deviation);
    return std::string(choice.mistake.empty() ? choice.defect : choice.mistake);
}

std::string cell_of(std::string value) {
    for (std::size_t at = 0; (at = value.find('"', at)) != value.npos; at += 2) value.insert(at, 1, '"');
    // A spreadsheet would take the cell for a formula.
    if (!value.empty() && std::string_view("=+-@").find(value.front()) != std::string_view::npos)
        value.insert(0, 1, '\'');
    return '"' + value + '"';
}

std::string line_of(const std::vector<std::string>& cells) {
    std::string line;
    for (const auto& each : cells) line += (line.empty() ? "" : ",") + cell_of(each);
    return escaped_for_terminal(line, "\n\t");
}

std::string text_of(const Json& json, int indent = -1) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string in_words(const std::vector<ReportedFault>& faults, const Words& say) {
    std::string text;
    for (const ReportedFault& fault : faults) {
        text += (text.empty() ? "" : "; ") + fault.scene + (fault.scene.empty() ? "" : ", ") + in_words(fault, say);
    }
    return text;
}

std::string as_csv(const std::string& program, const ProgramGrade& grade, const Words& say) {
    const SceneGrade* first = grade.first_wrong();
    const Wrong* claim = first && first->judgement && first->judgement->wrong ? &*first->judgement->wrong : nullptr;
    return line_of({program, std::string(grade.right() ? said_right : said_wrong), std::to_string(grade.scenes.size()),
                    std::to_string(grade.wrong()), first ? name_of(first->scene) : "",
                    claim ? std::to_string(claim->step) : "", claim ? claim->at : "", claim ? claim->claimed : "",
                    claim ? claim->right : "", grade.deviation ? name_of(*grade.deviation) : "",
                    in_words(grade.claims, say), grade.missing, in_words(grade.faults(), say)});
}

std::string as_json(const std::string& program, const ProgramGrade& grade, const Words& say) {
    Json entry{{"program", program}, {"verdict", grade.right() ? said_right : said_wrong}};
    entry["scenes"] = grade.scenes.size();
    entry["wrong"] = grade.wrong();
    if (const SceneGrade* first = grade.first_wrong()) {
        entry["first"] = {{"scene", name_of(first->scene)}};
        if (first->judgement && first->judgement->wrong) {
            const Wrong& claim = *first->judgement->wrong;
            entry["first"].update(
                {{"step", claim.step}, {"at", claim.at}, {"says", claim.claimed}, {"but", claim.right}});
        }
    }
    if (grade.deviation) entry["mistake"] = name_of(*grade.deviation);
    for (const auto& [kind, count] : grade.claims.counts) entry["told"][std::string(say.of(kind->name))] = count;
    if (!grade.missing.empty()) entry["missing"] = grade.missing;
    for (const ReportedFault& fault : grade.faults()) {
        entry["faults"].push_back({{"scene", fault.scene},
                                   {"step", fault.step},
                                   {"at", fault.at},
                                   {"reason", fault.reason},
                                   {"more", fault.more}});
    }
    return text_of(entry);
}

/// The first cells of a line; fewer if it has not as many.
std::vector<std::string> cells_in(std::string_view line, std::size_t most) {
    std::vector<std::string> cells;
    while (cells.size() < most && line.starts_with('"')) {
        std::string& cell = cells.emplace_back();
        std::size_t at = 1;
        for (; at < line.size() && (line[at] != '"' || line.substr(at, 2) == "\"\""); ++at) {
            if (line[at] == '"') ++at;
            cell += line[at];
        }
        line.remove_prefix(std::min(line.size(), at + 2));
    }
    return cells;
}

}  // namespace

std::optional<TableFormat> table_format_of(const std::string& file) {
    if (file.ends_with(".csv")) return TableFormat::csv;
    if (file.ends_with(".json")) return TableFormat::json;
    return std::nullopt;
}

TableLine line_of(std::string program, const ProgramGrade& grade, TableFormat format, const Words& say) {
    std::string text = format == TableFormat::csv ? as_csv(program, grade, say) : as_json(program, grade, say);
    return {std::move(program), std::move(text), grade.right()};
}

TableLine line_of(std::string program, const std::string& reason, TableFormat format) {
    std::string text = format == TableFormat::csv
                           ? line_of({program, std::string(not_judged), "", "", "", "", "", "", reason, "", "", "", ""})
                           : text_of({{"program", program}, {"verdict", not_judged}, {"reason", reason}});
    return {std::move(program), std::move(text), false};
}

std::string table_of(std::vector<TableLine> lines, TableFormat format) {
    std::sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.program < b.program; });
    if (format == TableFormat::csv) {
        std::string text(heading);
        for (const TableLine& line : lines) text += line.text + '\n';
        return text;
    }
    Json table = Json::array();
    for (const TableLine& line : lines) table.push_back(Json::parse(line.text));
    return text_of(table, 2) + '\n';
}

std::vector<TableLine> lines_of(const std::string& text, TableFormat format, const std::string& file) {
    std::vector<TableLine> lines;
    if (format == TableFormat::csv) {
        if (!text.starts_with(heading)) throw Refused(file + ": is no table of vidno grade");
        for (std::size_t at = heading.size(), end = 0; at < text.size(); at = end + 1) {
            end = std::min(text.find('\n', at), text.size());
            std::string line = text.substr(at, end - at);
            auto cells = cells_in(line, 2);
            if (cells.size() < 2) throw Refused(file + ": is no table of vidno grade");
            lines.push_back({std::move(cells[0]), std::move(line), cells[1] == said_right});
        }
        return lines;
    }
    try {
        for (const Json& entry : Json::parse(text)) {
            lines.push_back({entry.at("program"), text_of(entry), entry.at("verdict") == said_right});
        }
    } catch (const Json::exception&) {
        throw Refused(file + ": is no table of vidno grade");
    }
    return lines;
}

}  // namespace vidno
