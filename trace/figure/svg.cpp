#include "characters.h"
#include "json/json_text.h"
#include "writers.h"

namespace vidno::figures {

namespace {

constexpr std::string_view font_family = "Helvetica, Arial, 'Liberation Sans', 'Nimbus Sans', sans-serif";

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + escaped_for_xml(value) + "\"";
}

std::string millimetres(double points) { return decimal(points / points_per_millimetre); }

std::string data_of(const Path& path) {
    std::string data;
    for (const auto& line : path.lines) {
        data += 'M';
        for (const auto& [x, y] : line) data += (data.back() == 'M' ? "" : " ") + decimal(x) + " " + decimal(y);
        if (path.closed) data += 'Z';
    }
    return data;
}

std::string element(const Path& path) {
    std::string text = "<path" + attribute("fill", path.fill ? hex_of(*path.fill) : "none");
    if (const auto& stroke = path.stroke) {
        text += attribute("stroke", hex_of(stroke->color)) + attribute("stroke-width", millimetres(stroke->width));
        std::string dashes;
        for (const double dash : stroke->dashes) dashes += (dashes.empty() ? "" : " ") + millimetres(dash);
        if (!dashes.empty()) text += attribute("stroke-dasharray", dashes);
    }
    return text + attribute("d", data_of(path)) + "/>\n";
}

std::string element(const Label& label) {
    std::string text = "<text" + attribute("x", decimal(label.at.x)) + attribute("y", decimal(label.at.y)) +
                       attribute("font-size", millimetres(label.size));
    if (label.bold) text += attribute("font-weight", "bold");
    if (label.anchor != Anchor::start)
        text += attribute("text-anchor", label.anchor == Anchor::middle ? "middle" : "end");
    if (!(label.color == Color{})) text += attribute("fill", hex_of(label.color));
    return text + ">" + escaped_for_xml(label.text) + "</text>\n";
}

std::string opening_of(const Drawing& drawing, const About& about) {
    const std::string width = decimal(drawing.width);
    const std::string height = decimal(drawing.height);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
           attribute("width", width + "mm") + attribute("height", height + "mm") +
           attribute("viewBox", "0 0 " + width + " " + height) + attribute("xml:lang", code_of(about.language)) +
           attribute("font-family", font_family) + attribute("stroke-linejoin", "round") + ">\n<title>" +
           escaped_for_xml(about.title) + "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

std::string elements_of(const Drawing& drawing) {
    std::string text;
    for (const auto& thing : drawing.things) {
        text += std::visit([](const auto& each) { return element(each); }, thing);
    }
    return text;
}

}  // namespace

std::string svg_of(const Drawing& drawing, const About& about) {
    return opening_of(drawing, about) + elements_of(drawing) + "</svg>\n";
}

std::string film_of(const std::vector<Drawing>& frames, double frames_a_second, const About& about) {
    std::string text = opening_of(frames.front(), about);
    const auto count = double(frames.size());
    const std::string duration = decimal(count / frames_a_second) + "s";
    const auto share = [&](std::size_t frame) { return std::to_string(double(frame) / count); };
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const bool is_last = i + 1 == frames.size();
        text += "<g" + attribute("visibility", is_last ? "visible" : "hidden") + ">\n";
        if (frames.size() > 1) {
            const std::string shown = i == 0 ? "visible" : "hidden;visible";
            const std::string from = i == 0 ? "0" : "0;" + share(i);
            text += "<animate attributeName=\"visibility\" calcMode=\"discrete\" repeatCount=\"indefinite\"" +
                    attribute("dur", duration) + attribute("values", shown + (is_last ? "" : ";hidden")) +
                    attribute("keyTimes", from + (is_last ? "" : ";" + share(i + 1))) + "/>\n";
        }
        text += elements_of(frames[i]) + "</g>\n";
    }
    return text + "</svg>\n";
}

}  // namespace vidno::figures
