#include "sign_map/question_json.h"

#include <algorithm>
#include <cmath>

#include "json/json_node.h"
#include "scene/exact_scene.h"

namespace vidno {

namespace {

constexpr std::string_view question_format = "vidno-question/1";
constexpr std::array<std::string_view, 3> pivot_names{"p", "q", "r"};

ScenePolygon polygon_of(const JsonNode& node, auto&& vertex_of) {
    ScenePolygon polygon;
    for (std::size_t i = 0; i < node.size(); ++i) polygon.vertices.push_back(vertex_of(node.at(i)));
    const auto [admission, dropped] = exact_scene::admit(polygon);
    if (admission != Admission::admitted) node.refuse(reason_of(admission));
    if (dropped > 0) node.refuse(reason_of(Admission::not_convex));
    if (polygon.edge_on) node.refuse("seen edge-on");
    return polygon;
}

OrientationQuestion read_orientation(const JsonNode& node) {
    node.require_keys({"q", "r", "pivot"});
    const auto pivot = std::find(pivot_names.begin(), pivot_names.end(), node.at("pivot").text());
    if (pivot == pivot_names.end()) node.at("pivot").refuse("neither \"p\" nor \"q\" nor \"r\"");
    return {node.at("q").pair(), node.at("r").pair(), int(pivot - pivot_names.begin())};
}

SurroundQuestion read_surround(const JsonNode& node) {
    node.require_keys({"polygon"});
    return {polygon_of(node.at("polygon"), [](const JsonNode& vertex) { return glm::dvec3(vertex.pair(), 0); })};
}

ClipQuestion read_clip(const JsonNode& node, const Question& question) {
    node.require_keys({"q", "window", "cut", "side"});
    const Area window = node.at("window").window();
    const int cut = node.at("cut").whole_number(1, 3);
    const ClipQuestion asked{node.at("q").pair(), window, cut, node.at("side").whole_number(cut + 1, 4)};

    const std::array sides{window.y, window.x, window.bottom(), window.right()};
    const auto offset = [&](const glm::dvec2& v) { return (cut % 2 == 0 ? v.x : v.y) - sides[cut - 1]; };
    const double first = offset(question.place(0, 0));
    const double last = offset(question.place(Question::side - 1, Question::side - 1));
    const double q = offset(asked.q);
    const bool crosses = (first < 0 && last < 0 && q > 0) || (first > 0 && last > 0 && q < 0);
    if (!crosses) node.at("cut").refuse("the edge from p to q does not cross this side");
    return asked;
}

DepthQuestion read_depth(const JsonNode& node) {
    node.require_keys({"polygons"});
    const JsonNode polygons = node.at("polygons");
    if (polygons.size() != 2) polygons.refuse("not two polygons");
    const auto read = [&](std::size_t i) {
        return polygon_of(polygons.at(i), [](const JsonNode& vertex) { return vertex.triple(); });
    };
    return {{read(0), read(1)}};
}

Question read(const JsonNode& root) {
    root.require_keys({"format", "p", "step"}, {"name", "orientation", "surround", "clip", "depth"});
    if (root.at("format").text() != question_format) root.at("format").refuse("not \"vidno-question/1\"");
    Question question{};
    if (root.has("name")) question.name = root.at("name").text();
    question.p = root.at("p").pair();
    question.step = root.at("step").number();
    if (!(question.step > 0)) root.at("step").refuse("not positive");
    if (!exact_scene::are_doubles(question.p.x, question.step, Question::side) ||
        !exact_scene::are_doubles(question.p.y, question.step, Question::side)) {
        root.at("step").refuse("255 steps from p on, not every place is a double");
    }
    int decisions = 0;
    const auto if_asked = [&](std::string_view decision, auto&& read_decision) {
        if (!root.has(decision)) return;
        question.asked = read_decision(root.at(decision));
        ++decisions;
    };
    if_asked("orientation", read_orientation);
    if_asked("surround", read_surround);
    if_asked("clip", [&](const JsonNode& node) { return read_clip(node, question); });
    if_asked("depth", read_depth);
    if (decisions != 1) root.refuse("not exactly one of \"orientation\", \"surround\", \"clip\", \"depth\"");
    return question;
}

}  // namespace

Question read_question(std::string_view text, const std::string& file) { return read_json(text, file, read); }

}  // namespace vidno
