#include <algorithm>
#include <nlohmann/json.hpp>

#include "proof/proof.h"
#include "scene/scene_json.h"

namespace vidno {

namespace {

void append_reason(Text& out, int polygon) { append_integer(out, polygon); }
void append_pair(Text& out, int first, int second) {
    out += '[';
    append_integer(out, first);
    out += ',';
    append_integer(out, second);
    out += ']';
}
void append_reason(Text& out, const BesideEdge& reason) { append_pair(out, reason.polygon, reason.edge); }
void append_reason(Text& out, const Behind& reason) { append_pair(out, reason.polygon, reason.front); }

/// A member that is a list, unless it is empty.
void append_reasons(Text& out, std::string_view key, const auto& reasons) {
    if (reasons.empty()) return;
    out += ",\"";
    out += key;
    out += "\":";
    char before = '[';
    for (const auto& reason : reasons) {
        out += before;
        append_reason(out, reason);
        before = ',';
    }
    out += ']';
}

}  // namespace

void append_rectangle(Text& out, const ProvedRectangle& rectangle) {
    const auto& [x, y, width, height] = rectangle.pixels;
    out += "{\"rectangle\":";
    char before = '[';
    for (const int number : {x, y, width, height}) {
        out += before;
        append_integer(out, number);
        before = ',';
    }
    out += ']';
    append_reasons(out, "edge_on", rectangle.edge_on);
    append_reasons(out, "beside", rectangle.beside);
    append_reasons(out, "behind", rectangle.behind);
    if (rectangle.is_whole) {
        out += ",\"owner\":";
        if (rectangle.owner) append_integer(out, *rectangle.owner);
        if (!rectangle.owner) out += "null";
    }
    out += "}\n";
}

bool is_plain(std::string_view text, const Scene& scene) {
    using Json = nlohmann::json;
    const Json file = Json::parse(text, nullptr, false), meant = Json::parse(scene_json(scene));
    if (!file.is_object() || file.contains("camera") || file.value("window", Json()) != meant["window"]) return false;
    if (file.value("background", Json("#ffffff")) != meant["background"]) return false;
    const auto same = [](const Json& a, const Json& b) {
        return a.is_object() && a.value("color", Json()) == b["color"] && a.value("vertices", Json()) == b["vertices"];
    };
    const Json polygons = file.value("polygons", Json());
    return polygons.is_array() &&
           std::equal(polygons.begin(), polygons.end(), meant["polygons"].begin(), meant["polygons"].end(), same);
}

}  // namespace vidno
