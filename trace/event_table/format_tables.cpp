// The tables of FORMAT.md.

#include <algorithm>
#include <stdexcept>

#include "choice/kernel_choice.h"
#include "choice/method.h"
#include "event_table/event_table.h"
#include "event_table/joined_texts.h"

namespace vidno {

namespace {

std::string in_code(std::string_view text) { return "`" + std::string(text) + "`"; }

/// FORMAT.md has letters for the most frequent values.
std::string word_of(std::string_view name) {
    if (name == "number") return "N";
    if (name == "polygon") return "P";
    if (name == "color") return "C";
    if (name == shape_name<std::vector<ColumnRun>>) return "runs";
    return std::string(name);
}

std::string shape_text(const Shape& shape) {
    if (!shape.name.empty()) return word_of(shape.name);
    switch (shape.kind) {
        case Shape::Kind::named: break;
        case Shape::Kind::integer: return "int";
        case Shape::Kind::words:
            return joined_texts(shape.words, ", ", [](auto word) { return "`\"" + std::string(word) + "\"`"; });
        case Shape::Kind::numbers:
            return joined_texts(shape.numbers, ", ", [](int number) { return std::to_string(number); });
        case Shape::Kind::tuple: return "[" + joined_texts(shape.items, ", ", shape_text) + "]";
        case Shape::Kind::list: return "[" + shape_text(shape.items.front()) + ", ...]";
    }
    return "";
}

std::string value_text(const FieldDescription& field) {
    const Meaning& meaning = field.meaning;
    if (!meaning.word.empty()) {
        const std::string word(meaning.word);
        return field.shape.kind == Shape::Kind::list ? "[" + word + ", ...]" : word;
    }
    if (meaning.most != any_number.most) return std::to_string(meaning.least) + ".." + std::to_string(meaning.most);
    return shape_text(field.shape) + (meaning.least == any_number.least ? "" : " >= " + std::to_string(meaning.least));
}

/// The fields that `--check` adds are the same for every decision, so FORMAT.md describes them only once.
bool is_truth(const EventDescription& event, const FieldDescription& field) {
    const std::string_view name = field.shape.name;
    return event.decides &&
           (name == shape_name<Truth> || name == shape_name<FilterStage> || name == shape_name<Operands>);
}

std::string field_text(const FieldDescription& field) {
    const std::string value = value_text(field);
    return (field.is_optional ? "optionally " : "") + in_code(field.name) + (value == field.name ? "" : " " + value);
}

std::string lines_text(const LineSet& lines) {
    if (lines == LineSet::all()) return "any line";
    return joined_texts(names_of(lines), ", ", [](auto name) { return std::string(name); });
}

std::string row(const EventDescription& event) {
    std::vector<FieldDescription> fields;
    for (const auto& field : event.fields) {
        if (!is_truth(event, field)) fields.push_back(field);
    }
    std::string says(event.says);
    if (event.decides) says += "; decides " + in_code(decision_names[std::size_t(*event.decides)]);
    if (event.result_of) says += "; result of " + std::string(procedure_names[std::size_t(*event.result_of)]);
    return "| " + in_code(event.name) + " | " + lines_text(event.lines) + " | " +
           detail_names[std::size_t(event.from)][0] + " | " + joined_texts(fields, ", ", field_text) + " | " + says +
           " |\n";
}

std::string table(const EventGroup& group) {
    std::string text = "| event | at | from | fields | says |\n| --- | --- | --- | --- | --- |\n";
    for (const auto& event : group.events) text += row(event);
    return text;
}

std::string procedure_table() {
    std::string text = "| procedure | from | result |\n| --- | --- | --- |\n";
    const auto events = all_events();
    for (const Procedure procedure : called_procedures()) {
        std::vector<std::string_view> results;
        for (const auto& event : events) {
            if (event.result_of == procedure) results.push_back(event.name);
        }
        text += "| " + std::string(procedure_names[std::size_t(procedure)]) + " | " +
                detail_names[std::size_t(event::calls_from(procedure))][0] + " | " +
                joined_texts(results, ", ", in_code) + " |\n";
    }
    return text;
}

/// The kernels that run each edition of a method; editions with the same kernels share a row.
std::string method_rows(std::string_view method, auto&& runs) {
    std::vector<std::vector<std::string_view>> editions, kernels;
    for (const auto& named : named_editions) {
        std::vector<std::string_view> found;
        for (const auto& kernel : kernel_choices) {
            if (runs(kernel, named.edition)) found.push_back(kernel.name);
        }
        if (found.empty()) continue;
        const auto same = std::find(kernels.begin(), kernels.end(), found);
        if (same == kernels.end()) {
            kernels.push_back(found);
            editions.push_back({named.name});
        } else {
            editions[std::size_t(same - kernels.begin())].push_back(named.name);
        }
    }
    std::string rows;
    for (std::size_t i = 0; i < editions.size(); ++i) {
        rows += "| " + in_code(method) + " | " + joined_texts(editions[i], ", ", in_code) + " | " +
                joined_texts(kernels[i], ", ", in_code) + " |\n";
    }
    return rows;
}

std::string method_table() {
    std::string text = "| method | edition | kernel |\n| --- | --- | --- |\n";
    for (std::size_t i = 0; i < method_names.size(); ++i) {
        text += method_rows(method_names[i],
                            [i](const auto& kernel, Edition edition) { return kernel.runs(Method(i), edition); });
    }
    return text + method_rows(floating_horizon_method, [](const auto& kernel, Edition edition) {
               return kernel.runs_floating_horizon(edition);
           });
}

std::string edition_table() {
    std::string text = "| edition | text |\n| --- | --- |\n";
    for (const auto& named : named_editions) {
        text += "| " + in_code(named.name) + " | " + std::string(named.rule) + " |\n";
    }
    return text;
}

/// The defects of the printed text, and the lines that they change.
std::string defect_table() {
    std::string text = "| defect | lines | text |\n| --- | --- | --- |\n";
    for (const auto& choice : deviations) {
        if (choice.defect.empty()) continue;
        std::vector<std::string_view> lines;
        for (const Line line : choice.lines) lines.push_back(line_names[std::size_t(line)]);
        text += "| " + in_code(choice.defect) + " | " + joined_texts(lines, ", ", in_code) + " | " +
                std::string(choice.says.english) + " |\n";
    }
    return text;
}

std::string kernel_table() {
    std::string text = "| kernel | arithmetic |\n| --- | --- |\n";
    for (const auto& choice : kernel_choices) {
        std::string name(choice.name), numbers;
        if (choice.parameter) {
            const std::string letter(1, choice.parameter->letter);
            name += ":" + letter;
            numbers = "; " + letter + " from " + std::to_string(choice.parameter->least) + " to " +
                      std::to_string(choice.parameter->most);
        }
        text += "| " + in_code(name) + " | " + std::string(choice.rule) + numbers + " |\n";
    }
    return text;
}

void replace_part(std::string& text, std::string_view title, const std::string& derived) {
    const std::string begin = "<!-- derived: " + std::string(title) + " -->\n";
    const auto from = text.find(begin);
    const auto to = text.find("<!-- end -->", from);
    if (from == std::string::npos || to == std::string::npos) throw std::runtime_error("FORMAT.md: no " + begin);
    text.replace(from + begin.size(), to - from - begin.size(), "\n" + derived + "\n");
}

}  // namespace

std::string with_format_tables(const std::string& format) {
    std::string text = format;
    replace_part(text, "methods", method_table());
    replace_part(text, "editions", edition_table());
    replace_part(text, "defects", defect_table());
    replace_part(text, "kernels", kernel_table());
    replace_part(text, "procedures", procedure_table());
    for (const auto& group : event_table()) replace_part(text, group.title, table(group));
    return text;
}

}  // namespace vidno
