/// Reading checks in this order: the text as JSON (depth and repeated keys while it is parsed), the keys and types, the
/// values, and last the polygons' shapes, exactly. The first fault ends it.
#include "scene/scene_json.h"

#include <cmath>
#include <optional>
#include <unordered_set>
#include <utility>

#include "json/json_node.h"
#include "json/json_text.h"
#include "json/unique_ids.h"
#include "scene/exact_scene.h"
#include "scene/quick_scene.h"
#include "vidno/camera.h"

namespace vidno {
namespace {

constexpr std::string_view scene_format = "vidno-scene/1";

Camera read_camera(const JsonNode& node, const Area& area) {
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

std::string read_id(const JsonNode& node, std::size_t position) {
    if (!node.has("id")) return std::to_string(position);
    const JsonNode id = node.at("id");
    if (id.text().empty()) id.refuse("empty");
    if (id.text().size() > longest_id) id.refuse("longer than " + std::to_string(longest_id) + " bytes");
    return id.text();
}

ScenePolygon read_polygon(const JsonNode& node, std::size_t position) {
    node.require_keys({"color", "vertices"}, {"id"});
    ScenePolygon polygon;
    polygon.id = read_id(node, position);
    polygon.color = node.at("color").color();
    const JsonNode vertices = node.at("vertices");
    const std::size_t count = vertices.size();
    polygon.vertices.reserve(count);
    for (std::size_t i = 0; i < count; ++i) polygon.vertices.push_back(vertices.at(i).triple());
    return polygon;
}

/// Says of a polygon that is refused for its depth which z it is.
void refuse_shape(const JsonNode& node, const ScenePolygon& polygon, Admission admission) {
    const JsonNode vertices = node.at("vertices");
    if (admission == Admission::out_of_depth_range) {
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
            if (!(std::abs(polygon.vertices[i].z) <= 1)) vertices.at(i).at(2u).refuse(reason_of(admission));
        }
    }
    vertices.refuse(reason_of(admission));
}

class SceneReader {
public:
    explicit SceneReader(std::string file) : file_(std::move(file)) {}

    SceneWithWarnings read(const JsonNode& root) {
        root.require_keys({"format", "window", "polygons"}, {"name", "background", "camera"});
        if (root.at("format").text() != scene_format) root.at("format").refuse("not \"vidno-scene/1\"");
        Scene& scene = result_.scene;
        if (root.has("name")) scene.name = root.at("name").text();
        scene.area = root.at("window").window();
        if (root.has("background")) scene.background = root.at("background").color();
        if (root.has("camera")) view_ = view_of(read_camera(root.at("camera"), scene.area), scene.area);
        read_polygons(root.at("polygons"));
        return std::move(result_);
    }

private:
    void read_polygons(const JsonNode& node) {
        if (node.size() > most_polygons) node.refuse("more than " + std::to_string(most_polygons) + " polygons");
        std::vector<ScenePolygon> polygons;
        std::unordered_set<std::string> ids;
        polygons.reserve(node.size());
        for (std::size_t i = 0; i < node.size(); ++i) {
            polygons.push_back(read_polygon(node.at(i), i));
            if (ids.insert(polygons.back().id).second) continue;
            const JsonNode polygon = node.at(i);
            if (polygon.has("id")) polygon.at("id").refuse("the id is there twice");
            polygon.refuse("the id is there twice: without one it is the position");
        }
        PartIds part_ids(std::move(ids));
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const JsonNode polygon = node.at(i);
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

    void add(const JsonNode& node, ScenePolygon polygon, std::size_t position) {
        const Admitted admitted = exact_scene::admit(polygon);
        if (admitted.admission != Admission::admitted) refuse_shape(node, polygon, admitted.admission);
        warn_of_dropped(position, admitted.dropped);
        result_.scene.polygons.push_back(std::move(polygon));
    }

    void add_seen(const JsonNode& node, ScenePolygon polygon, std::size_t position, PartIds& part_ids) {
        const Admitted admitted = exact_scene::admit_in_world(polygon);
        if (admitted.admission != Admission::admitted) refuse_shape(node, polygon, admitted.admission);
        Seen seen = exact_scene::look(*view_, polygon);
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

    std::string file_;
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
    if (auto scene = read_quickly(text)) return {std::move(*scene), {}};
    return read_json(text, file, [&](const JsonNode& root) { return SceneReader(file).read(root); });
}

Scene read_scene(const JsonNode& node) { return SceneReader("").read(node).scene; }

std::string scene_json(const Scene& scene) {
    Text out;
    out += "{\"format\":\"";
    out += scene_format;
    out += "\",\"name\":";
    append_string(out, scene.name);
    out += ",\"window\":";
    append_area(out, scene.area);
    out += ",\"background\":";
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
