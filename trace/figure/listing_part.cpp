#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "listings_text.h"
#include "parts.h"
#include "table.h"
#include "wrap.h"

namespace vidno::figures {

namespace {

using nlohmann::json;

const json& procedures() {
    static const json read = json::parse(listings_text).at("procedures");
    return read;
}

bool has_line(const json& procedure, std::string_view label) {
    const auto& lines = procedure.at("lines");
    return std::any_of(lines.begin(), lines.end(), [&](const json& line) { return line.at("at") == label; });
}

/// The procedure of the current line; before its first line, the one that is running.
const json& procedure_at(const CallStack::Frame& frame) {
    const auto& all = procedures();
    const auto found = std::find_if(all.begin(), all.end(), [&](const json& procedure) {
        return frame.at ? has_line(procedure, line_names[std::size_t(*frame.at)])
                        : procedure.at("name") == procedure_names[std::size_t(frame.of)];
    });
    return *found;  // a test checks that the listings have every label and name
}

/// Whether the edition has a line as printed.
bool is_as_printed(const json& line, Edition edition) {
    if (!line.contains("printed")) return false;
    if (edition == Edition::printed) return true;
    for (std::string defect : line.at("printed").at("defects")) {
        std::transform(defect.begin(), defect.end(), defect.begin(), [](unsigned char c) { return std::tolower(c); });
        const auto named = defect_named(defect);
        if (named && edition.has(*named)) return true;
    }
    return false;
}

/// The text of a line in the edition.
std::string text_in(const json& line, Edition edition, Language language) {
    if (is_mistake(edition)) {
        const DeviationChoice& mistake = choice_of(*single_deviation(edition));
        for (std::size_t i = 0; i < mistake.lines.size(); ++i) {
            if (line.at("at") != line_names[std::size_t(mistake.lines[i])]) continue;
            return std::string(mistake.reads[i].in(language));
        }
    }
    return (is_as_printed(line, edition) ? line.at("printed") : line).at(code_of(language));
}

}  // namespace

std::string text_of(Line at, Edition edition, Language language) {
    const std::string_view label = line_names[std::size_t(at)];
    for (const json& procedure : procedures()) {
        for (const json& line : procedure.at("lines")) {
            if (line.at("at") == label) return text_in(line, edition, language);
        }
    }
    return {};  // a test checks that the listings have every label
}

Drawing listing_part(const CallStack::Frame& frame, Edition edition, const Style& style, double width) {
    constexpr double number_at = 2.6, text_at = 9.4, level = 2.6, hanging = 2.6, base_below = 1.1;
    const json& procedure = procedure_at(frame);

    Drawing drawing{width, 0};
    double y = 0;
    const auto put = [&](const std::string& text, double x, double size) {
        drawing.add(Label{text, {x, y - base_below}, size, Anchor::start, false, ink});
    };
    const auto rule = [&](double at, double thickness) {
        drawing.add(Path{{{{0, at}, {width, at}}}, false, {}, Stroke{ink, thickness}});
    };
    const std::string name = procedure.at("name");
    const std::string head = name + "(" + std::string(procedure.at("takes")) + ")";
    constexpr double bold = 1.08;  // wider
    const double room = width / style.letters / bold;
    const auto heads = wrapped(head, text_size, room, room);
    y = line_height * double(heads.size());
    if (!frame.at) drawing.add(rectangle({0, 0, width, y}, band));
    for (std::size_t i = 0; i < heads.size(); ++i) {
        const Point at{i == 0 ? 0 : hanging, line_height * double(i + 1) - base_below};
        drawing.add(Label{heads[i], at, text_size, Anchor::start, true, ink});
    }
    rule(y, 0.75);
    y += 0.4;
    for (const json& line : procedure.at("lines")) {
        const std::string text = text_in(line, edition, style.language);
        const double left = text_at + level * int(line.at("indent"));
        const auto pieces =
            wrapped(text, text_size, (width - left - hanging) / style.letters, (width - left) / style.letters);
        if (frame.at && line.at("at") == line_names[std::size_t(*frame.at)]) {
            drawing.add(rectangle({0, y + 0.15, width, line_height * double(pieces.size())}, band));
            add_arrow(drawing, 0.4, y + line_height - base_below - 0.1);
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            y += line_height;
            if (i == 0) put(line.at("at"), number_at, small_size);
            put(pieces[i], left + (i == 0 ? 0 : hanging), text_size);
        }
    }
    rule(y + 0.5, 0.75);
    drawing.height = y + 0.8;
    return drawing;
}

}  // namespace vidno::figures
