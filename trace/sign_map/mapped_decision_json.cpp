#include "sign_map/mapped_decision_json.h"

#include <algorithm>
#include <cmath>

#include "json/json_node.h"
#include "scene/exact_scene.h"

namespace vidno {

namespace {

constexpr std::string_view format = "vidno-question/1";
constexpr std::array<std::string_view, 3> pivot_names{"p", "q", "r"};

ScenePolygon polygon_of(const JsonNode& node, auto&& vertex_of) {
    ScenePolygon polygon;
    for (std::size_t i = 0; i < node.size(); ++i) polygon.vertices.push_back(vertex_of(node.at(i)));
    const auto [admission, dropped] = exact_scene::admit_polygon(polygon);
    if (admission != Admission::admitted) node.refuse(reason_of(admission));
    if (dropped > 0) node.refuse("not exactly convex, as a map requires");
    if (polygon.edge_on) node.refuse("seen edge-on");
    return polygon;
}

MappedOrientation read_orientation(const JsonNode& node) {
    node.require_keys({"q", "r", "pivot"});
    const auto pivot = std::find(pivot_names.begin(), pivot_names.end(), node.at("pivot").text());
    if (pivot == pivot_names.end()) node.at("pivot").refuse("not \"p\", \"q\" or \"r\"");
    return {node.at("q").pair(), node.at("r").pair(), int(pivot - pivot_names.begin())};
}

MappedSurround read_surround(const JsonNode& node) {
    node.require_keys({"polygon"});
    return {polygon_of(node.at("polygon"), [](const JsonNode& vertex) { return glm::dvec3(vertex.pair(), 0); })};
}

MappedClip read_clip(const JsonNode& node, const MappedDecision& decision) {
    node.require_keys({"q", "window", "cut", "side"});
    const Area window = node.at("window").window();
    const int cut = node.at("cut").whole_number(1, 3);
    const MappedClip asked{node.at("q").pair(), window, cut, node.at("side").whole_number(cut + 1, 4)};

    const std::array sides{window.y, window.x, window.bottom(), window.right()};
    const auto offset = [&](const glm::dvec2& v) { return (cut % 2 == 0 ? v.x : v.y) - sides[cut - 1]; };
    const double first = offset(decision.place(0, 0));
    const double last = offset(decision.place(MappedDecision::side - 1, MappedDecision::side - 1));
    const double q = offset(asked.q);
    const bool crosses = (first < 0 && last < 0 && q > 0) || (first > 0 && last > 0 && q < 0);
    if (!crosses) node.at("cut").refuse("the edge from p to q does not cross this side");
    return asked;
}

MappedDepth read_depth(const JsonNode& node) {
    node.require_keys({"polygons"});
    const JsonNode polygons = node.at("polygons");
    if (polygons.size() != 2) polygons.refuse("not two polygons");
    const auto read = [&](std::size_t i) {
        return polygon_of(polygons.at(i), [](const JsonNode& vertex) { return vertex.triple(); });
    };
    return {{read(0), read(1)}};
}

MappedDecision decision_in(const JsonNode& root) {
    root.object();
    root.expect_format(format);
    root.require_keys({"format", "p", "step"}, {"name", "orientation", "surround", "clip", "depth"});
    MappedDecision decision{};
    if (root.has("name")) decision.name = root.at("name").text();
    decision.p = root.at("p").pair();
    decision.step = root.at("step").number();
    if (!(decision.step > 0)) root.at("step").refuse("not positive");
    if (!exact_scene::are_doubles(decision.p.x, decision.step, MappedDecision::side) ||
        !exact_scene::are_doubles(decision.p.y, decision.step, MappedDecision::side)) {
        root.at("step").refuse("255 steps from p on, not every place is a double");
    }
    int decisions = 0;
    const auto if_asked = [&](std::string_view kind, auto&& read_kind) {
        if (!root.has(kind)) return;
        decision.asked = read_kind(root.at(kind));
        ++decisions;
    };
    if_asked("orientation", read_orientation);
    if_asked("surround", read_surround);
    if_asked("clip", [&](const JsonNode& node) { return read_clip(node, decision); });
    if_asked("depth", read_depth);
    if (decisions != 1) root.refuse("not exactly one of \"orientation\", \"surround\", \"clip\", \"depth\"");
    return decision;
}

}  // namespace

MappedDecision read_mapped_decision(std::string_view text, const std::string& file) {
    return read_json(text, file, decision_in);
}

}  // namespace vidno
