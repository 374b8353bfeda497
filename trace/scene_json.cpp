/// Reading checks in this order: the text as JSON (depth and repeated keys while it is parsed), the keys and types, the
/// values, and last the polygons' shapes, exactly. The first fault ends it.
#include "scene_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <system_error>
#include <unordered_set>
#include <utility>

#include "json_text.h"
#include "refused.h"
#include "unique_ids.h"
#include "vidno/admission.h"
#include "vidno/camera.h"
#include "vidno/look.h"

namespace vidno {
namespace {

using nlohmann::json;

constexpr std::string_view scene_format = "vidno-scene/1";
constexpr int deepest_nesting = 16;

/// Text from a file inside a message of one line: no control characters, and not too long.
std::string printable(std::string_view text) {
    constexpr std::size_t most = 100;
    std::string out(first_bytes(text, most));
    for (char& c : out) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    }
    if (out.size() < text.size()) out += "...";
    return out;
}

/// A key as a step of a JSON pointer (RFC 6901).
std::string pointer_step(std::string_view key) {
    std::string step = "/";
    for (const char c : printable(key)) {
        if (c == '~') {
            step += "~0";
        } else if (c == '/') {
            step += "~1";
        } else {
            step += c;
        }
    }
    return step;
}

[[noreturn]] void refuse_at(const std::string& pointer, std::string_view reason) {
    throw Refused((pointer.empty() ? "" : pointer + ": ") + std::string(reason));
}

std::string line_and_column(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, position > 0 ? position - 1 : 0);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1);  // npos + 1 is 0
    return "line " + std::to_string(lines + 1) + ", column " + std::to_string(column + 1);
}

/// Hears the parser, and refuses what a tree would not show any more: text that is not JSON, with its place, nesting
/// that is too deep, and a key that an object has twice. (A tree's own parser with a callback takes quadratic time.)
class ParserWatch : public nlohmann::json_sax<json> {
public:
    explicit ParserWatch(std::string_view text) : text_(text) {}

    bool null() override { return next(); }
    bool boolean(bool) override { return next(); }
    bool number_integer(number_integer_t) override { return next(); }
    bool number_unsigned(number_unsigned_t) override { return next(); }
    bool number_float(number_float_t, const string_t&) override { return next(); }
    bool string(string_t&) override { return next(); }
    bool binary(binary_t&) override { return next(); }
    bool start_object(std::size_t) override { return open(true); }
    bool start_array(std::size_t) override { return open(false); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        levels_.back().key = name;
        if (!levels_.back().keys.insert(name).second) refuse_at(pointer(), "the key is there twice");
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const json::exception& error) override {
        constexpr int number_overflow = 406;
        if (error.id == number_overflow) refuse_at(pointer(), "the number is beyond the range of doubles");
        refuse_at(line_and_column(text_, position), "not valid JSON");
    }

private:
    struct Level {
        bool is_object;
        std::size_t index = 0;
        std::string key;
        std::set<std::string> keys;
    };

    std::string pointer() const {
        std::string out;
        for (const Level& level : levels_) {
            if (level.is_object && level.keys.empty()) break;
            out += level.is_object ? pointer_step(level.key) : "/" + std::to_string(level.index);
        }
        return out;
    }

    bool open(bool is_object) {
        if (int(levels_.size()) == deepest_nesting) refuse_at(pointer(), "nested too deeply");
        levels_.push_back({is_object, 0, {}, {}});
        return true;
    }

    bool close() {
        levels_.pop_back();
        return next();
    }

    bool next() {
        if (!levels_.empty()) ++levels_.back().index;
        return true;
    }

    std::string_view text_;
    std::vector<Level> levels_;
};

json parse(std::string_view text) {
    ParserWatch watch(text);
    json::sax_parse(text, &watch);
    return json::parse(text);
}

/// A value and where it stands. Only what goes wrong costs the making of a path.
class Node {
public:
    explicit Node(const json& value) : value_(value) {}

    [[noreturn]] void refuse(std::string_view reason) const { refuse_at(pointer(), reason); }

    /// An object with all of the required keys and none but these and the optional ones.
    void require_keys(std::initializer_list<std::string_view> required,
                      std::initializer_list<std::string_view> optional = {}) const {
        if (!value_.is_object()) refuse("not an object");
        const auto is_in = [](const auto& keys, const std::string& key) {
            return std::find(keys.begin(), keys.end(), key) != keys.end();
        };
        for (const auto& [key, value] : value_.items()) {
            if (!is_in(required, key) && !is_in(optional, key)) at(key).refuse("unknown key");
        }
        for (const std::string_view key : required) {
            if (!has(key)) refuse("\"" + std::string(key) + "\" is missing");
        }
    }

    bool has(std::string_view key) const { return value_.contains(key); }
    Node at(std::string_view key) const { return Node(*value_.find(key), this, key, 0); }

    std::size_t size() const {
        if (!value_.is_array()) refuse("not an array");
        return value_.size();
    }
    Node at(std::size_t index) const { return Node(value_[index], this, {}, index); }

    const std::string& text() const {
        if (!value_.is_string()) refuse("not a string");
        return value_.get_ref<const std::string&>();
    }

    int whole_number(int least, int greatest) const {
        const double number = value_.is_number() ? value_.get<double>() : 0.5;
        if (number != std::floor(number)) refuse("not a whole number");
        if (number < least || number > greatest) {
            refuse("not from " + std::to_string(least) + " to " + std::to_string(greatest));
        }
        return int(number);
    }

    /// A number, or one written as hexadecimal text. -0 becomes 0.
    double number() const {
        if (value_.is_number()) return value_.get<double>() + 0.0;
        if (!value_.is_string()) refuse("neither a number nor a hexadecimal one as text, such as \"0x1.8p-3\"");
        return hexadecimal() + 0.0;
    }

    glm::dvec3 triple() const {
        if (size() != 3) refuse("not three coordinates");
        return {at(0u).number(), at(1u).number(), at(2u).number()};
    }

    Color color() const {
        const std::string& code = text();
        std::uint32_t rgb = 0;
        const char* end = code.data() + code.size();
        if (code.size() != 7 || code[0] != '#' || std::from_chars(code.data() + 1, end, rgb, 16).ptr != end) {
            refuse("not a colour of the form \"#rrggbb\"");
        }
        return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb)};
    }

private:
    Node(const json& value, const Node* parent, std::string_view key, std::size_t index)
        : value_(value), parent_(parent), key_(key), index_(index) {}

    std::string pointer() const {
        if (parent_ == nullptr) return "";
        const bool in_object = parent_->value_.is_object();
        return parent_->pointer() + (in_object ? pointer_step(key_) : "/" + std::to_string(index_));
    }

    /// [-]0x h+ [. h*] p [+-] d+
    double hexadecimal() const {
        std::string_view rest = text();
        const bool negative = rest.starts_with('-');
        if (negative) rest.remove_prefix(1);
        const bool prefixed = rest.starts_with("0x") || rest.starts_with("0X");
        rest.remove_prefix(prefixed ? 2 : 0);
        constexpr std::string_view digits = "0123456789abcdefABCDEF";
        const bool well_begun =
            prefixed && rest.find_first_not_of(digits) > 0 && rest.find_first_of("pP") < rest.size();
        double value = 0;
        const auto [end, error] =
            std::from_chars(rest.data(), rest.data() + rest.size(), value, std::chars_format::hex);
        if (error == std::errc::result_out_of_range) refuse("the number is beyond the range of doubles");
        if (!well_begun || error != std::errc() || end != rest.data() + rest.size()) {
            refuse("not a hexadecimal number such as \"0x1.8p-3\"");
        }
        return negative ? -value : value;
    }

    const json& value_;
    const Node* parent_ = nullptr;
    std::string_view key_;
    std::size_t index_ = 0;
};

Area read_window(const Node& node) {
    node.require_keys({"x", "y", "width", "height"});
    return {node.at("x").whole_number(-farthest_offset, farthest_offset),
            node.at("y").whole_number(-farthest_offset, farthest_offset),
            node.at("width").whole_number(1, largest_side), node.at("height").whole_number(1, largest_side)};
}

Camera read_camera(const Node& node, const Area& area) {
    Camera camera;
    if (node.has("projection") && node.at("projection").text() == "orthographic") {
        node.require_keys({"eye", "target", "projection", "height", "near", "far"}, {"up"});
        camera.projection = Projection::orthographic;
        camera.height = node.at("height").number();
    } else {
        node.require_keys({"eye", "target", "projection", "fov", "near", "far"}, {"up"});
        if (node.at("projection").text() != "perspective") {
            node.at("projection").refuse("neither \"perspective\" nor \"orthographic\"");
        }
        camera.field_of_view = node.at("fov").number();
    }
    camera.eye = node.at("eye").triple();
    camera.target = node.at("target").triple();
    if (node.has("up")) camera.up = node.at("up").triple();
    camera.near_distance = node.at("near").number();
    camera.far_distance = node.at("far").number();
    if (const auto defect = defect_of(camera, area)) node.refuse(*defect);
    return camera;
}

std::string read_id(const Node& node, std::size_t position) {
    if (!node.has("id")) return std::to_string(position);
    const Node id = node.at("id");
    if (id.text().empty()) id.refuse("empty");
    if (id.text().size() > longest_id) id.refuse("longer than " + std::to_string(longest_id) + " bytes");
    return id.text();
}

ScenePolygon read_polygon(const Node& node, std::size_t position) {
    node.require_keys({"color", "vertices"}, {"id"});
    ScenePolygon polygon;
    polygon.id = read_id(node, position);
    polygon.color = node.at("color").color();
    const Node vertices = node.at("vertices");
    const std::size_t count = vertices.size();
    polygon.vertices.reserve(count);
    for (std::size_t i = 0; i < count; ++i) polygon.vertices.push_back(vertices.at(i).triple());
    return polygon;
}

/// Says of a polygon that is refused for its depth which z it is.
void refuse_shape(const Node& node, const ScenePolygon& polygon, Admission admission) {
    const Node vertices = node.at("vertices");
    if (admission == Admission::out_of_depth_range) {
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
            if (!(std::abs(polygon.vertices[i].z) <= 1)) vertices.at(i).at(2u).refuse(reason_of(admission));
        }
    }
    vertices.refuse(reason_of(admission));
}

class SceneReader {
public:
    explicit SceneReader(const std::string& file) : file_(file) {}

    SceneWithWarnings read(const Node& root) {
        root.require_keys({"format", "window", "polygons"}, {"name", "background", "camera"});
        if (root.at("format").text() != scene_format) root.at("format").refuse("not \"vidno-scene/1\"");
        Scene& scene = result_.scene;
        if (root.has("name")) scene.name = root.at("name").text();
        scene.area = read_window(root.at("window"));
        if (root.has("background")) scene.background = root.at("background").color();
        if (root.has("camera")) view_ = view_of(read_camera(root.at("camera"), scene.area), scene.area);
        read_polygons(root.at("polygons"));
        return std::move(result_);
    }

private:
    void read_polygons(const Node& node) {
        if (node.size() > most_polygons) node.refuse("more than " + std::to_string(most_polygons) + " polygons");
        std::vector<ScenePolygon> polygons;
        std::unordered_set<std::string> ids;
        polygons.reserve(node.size());
        for (std::size_t i = 0; i < node.size(); ++i) {
            polygons.push_back(read_polygon(node.at(i), i));
            if (ids.insert(polygons.back().id).second) continue;
            const Node polygon = node.at(i);
            if (polygon.has("id")) polygon.at("id").refuse("the id is there twice");
            polygon.refuse("the id is there twice: without one it is the position");
        }
        PartIds part_ids(std::move(ids));
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const Node polygon = node.at(i);
            if (view_) {
                add_seen(polygon, std::move(polygons[i]), i, part_ids);
            } else {
                add(polygon, std::move(polygons[i]), i);
            }
        }
        if (result_.scene.polygons.size() > most_polygons) {
            node.refuse("cut into more than " + std::to_string(most_polygons) + " polygons");
        }
    }

    void add(const Node& node, ScenePolygon polygon, std::size_t position) {
        const Admitted admitted = admit(polygon);
        if (admitted.admission != Admission::admitted) refuse_shape(node, polygon, admitted.admission);
        warn_of_dropped(position, admitted.dropped);
        result_.scene.polygons.push_back(std::move(polygon));
    }

    void add_seen(const Node& node, ScenePolygon polygon, std::size_t position, PartIds& part_ids) {
        const Admitted admitted = admit_in_world(polygon);
        if (admitted.admission != Admission::admitted) refuse_shape(node, polygon, admitted.admission);
        Seen seen = look(*view_, polygon);
        warn_of_dropped(position, admitted.dropped + seen.dropped);
        if (polygon.edge_on) {
            warn(position, "no area, left out");
            return;
        }
        if (seen.polygons.empty()) warn(position, "not in view, left out");
        if (seen.polygons.size() > 1) {
            warn(position, "cut into " + std::to_string(seen.polygons.size()) + " triangles, for rounding bent it");
        }
        part_ids.name(seen.polygons);
        for (auto& part : seen.polygons) result_.scene.polygons.push_back(std::move(part));
    }

    void warn_of_dropped(std::size_t position, std::size_t count) {
        if (count == 0) return;
        warn(position, std::to_string(count) + (count == 1 ? " vertex" : " vertices") + " reflex by rounding, dropped");
    }

    void warn(std::size_t position, const std::string& what) {
        result_.warnings.push_back(file_ + ": /polygons/" + std::to_string(position) + ": " + what);
    }

    const std::string& file_;
    std::optional<View> view_;
    SceneWithWarnings result_;
};

void append_vertex(Text& out, const glm::dvec3& vertex) {
    out += '[';
    append_number(out, vertex.x);
    out += ',';
    append_number(out, vertex.y);
    out += ',';
    append_number(out, vertex.z);
    out += ']';
}

void append_polygon(Text& out, const ScenePolygon& polygon) {
    out += "{\"id\":";
    append_string(out, polygon.id);
    out += ",\"color\":";
    append_color(out, polygon.color);
    out += ",\"vertices\":[";
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        if (i > 0) out += ',';
        append_vertex(out, polygon.vertices[i]);
    }
    out += "]}";
}

}  // namespace

SceneWithWarnings read_scene(std::string_view text, const std::string& file) {
    try {
        const json document = parse(text);
        return SceneReader(file).read(Node(document));
    } catch (const Refused& refused) {
        throw Refused(file + ": " + refused.what());
    }
}

std::string scene_json(const Scene& scene) {
    Text out;
    out += "{\"format\":\"";
    out += scene_format;
    out += "\",\"name\":";
    append_string(out, scene.name);
    out += ",\"window\":{\"x\":";
    append_integer(out, scene.area.x);
    out += ",\"y\":";
    append_integer(out, scene.area.y);
    out += ",\"width\":";
    append_integer(out, scene.area.width);
    out += ",\"height\":";
    append_integer(out, scene.area.height);
    out += "},\"background\":";
    append_color(out, scene.background);
    out += ",\"polygons\":[";
    for (std::size_t i = 0; i < scene.polygons.size(); ++i) {
        if (i > 0) out += ',';
        append_polygon(out, scene.polygons[i]);
    }
    out += "]}";
    return out.string();
}

}  // namespace vidno
